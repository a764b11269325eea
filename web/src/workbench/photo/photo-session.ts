/** A photo on its way to a print: the reading, the user's changes, and the tile. */
import {exifTags} from '../../image/exif.js';
import type {Failure} from '../../model/base/failure.js';
import type {Point} from '../../model/geometry/vectors.js';
import {begun, redone, stepped, undone, type History} from '../../model/design/history.js';
import type {
  KnownObject,
  PhotoMap,
  PhotoPixels,
  PhotoSettings,
  PhotoStage,
  PointsMeasured,
  RepeatsMeasured,
} from '../../model/print/photo-reading.js';
import type {SolverService} from '../../solver/service.js';
import {NewestTask} from '../background-task.js';
import {toFailure} from '../latest-solve.js';
import {Observable} from '../observable.js';
import {stepOf, tileSettings, unmeasured, type PhotoStep} from '../../photo/photo-step.js';
import {steadied} from '../../photo/steady-cell.js';
import {gainsAt} from '../../photo/white-spot.js';
import type {PhotoKeeper, UnfinishedPhoto} from '../../photo/photo-keeper.js';

type PhotoState =
  | {readonly kind: 'reading'; readonly stage: PhotoStage; readonly fraction: number}
  | {readonly kind: 'done' | 'cancelled'}
  | {readonly kind: 'failed'; readonly failure: Failure};

/** Search for a coin or card, and its last outcome unless that is a step of the history. */
type ObjectSearch =
  | {readonly kind: 'none'}
  | {readonly kind: 'looking'; readonly stage: PhotoStage; readonly fraction: number}
  | {readonly kind: 'failed'; readonly failure: Failure};

type Asked = Pick<SolverService, 'photo' | 'photoTile' | 'photoObject'>;

/** Length of the head of a file, in which cameras store metadata. [bytes] */
const head = 256 * 1024;

/** Returns the focal length in the file, converted to film of 36 mm. */
async function focalLengthOf(picture: Blob): Promise<number | undefined> {
  const view = new DataView(await picture.slice(0, head).arrayBuffer());
  try {
    return view.getUint16(0) === 0xffd8 ? exifTags(view).f35 : undefined;
  } catch {
    return undefined; // truncated: the decoder reports that
  }
}

interface Made {
  readonly key: string;
  readonly pixels: Promise<PhotoPixels>;
}

export class PhotoSession extends Observable {
  readonly picture: Blob;
  readonly #solver: Asked;
  readonly #reads = new NewestTask();
  readonly #tiles = new NewestTask();
  readonly #searches = new NewestTask();
  #search: ObjectSearch = {kind: 'none'};
  #state: PhotoState = {kind: 'cancelled'};
  #history: History<PhotoStep> | undefined;
  #made: Made | undefined;

  constructor(solver: Asked, picture: Blob) {
    super();
    this.#solver = solver;
    this.picture = picture;
  }

  get state(): PhotoState {
    return this.#state;
  }

  get search(): ObjectSearch {
    return this.#search;
  }

  /** Undefined until the photo has been read. */
  get step(): PhotoStep | undefined {
    return this.#history?.present;
  }

  get canUndo(): boolean {
    return (this.#history?.past.length ?? 0) > 0;
  }

  get canRedo(): boolean {
    return (this.#history?.future.length ?? 0) > 0;
  }

  /** Reads the print; another reading is a separate step of the history. */
  begin(): Promise<void> {
    return this.#read({});
  }

  get history(): History<PhotoStep> | undefined {
    return this.#history;
  }

  /** Restores an earlier state. */
  resume(history: History<PhotoStep>): void {
    this.#history = history;
    this.#become({kind: 'done'});
  }

  /** Reads the print from a given lattice, which is refined unless `keeps`. */
  align(lattice: PhotoMap, keeps = false): Promise<void> {
    return this.#read({lattice, ...(keeps && {keepsLattice: true})});
  }

  /** Cancels the reading; an earlier reading stays. */
  cancel(): void {
    if (this.#state.kind !== 'reading') return;
    this.#reads.stop();
    this.#become({kind: this.step ? 'done' : 'cancelled'});
  }

  change(change: Partial<Omit<PhotoStep, 'reading'>>): void {
    if (!this.#history) return;
    this.#reads.stop();
    this.#searches.stop();
    this.#history = stepped(this.#history, {...this.#history.present, ...change});
    this.#become({kind: 'done'});
  }

  /** Sets the length of several repeats, which replaces other kinds of measurement. */
  measure(vector: 'w1' | 'w2', measured: RepeatsMeasured): void {
    this.change({[`${vector}Measured`]: measured, between: undefined, object: undefined});
  }

  /** Sets the distance between two points, which replaces other kinds of measurement. */
  measureBetween(between: PointsMeasured): void {
    this.change({...unmeasured, between});
  }

  /** Measures by a coin or card at this place; reports a failure if none is visible. */
  async measureBy(object: KnownObject, at: Point): Promise<void> {
    const {step} = this;
    if (!step) return;
    const {signal} = this.#searches.begin();
    const {map, shape} = step.reading;
    this.#found({kind: 'looking', stage: 'object', fraction: 0});
    try {
      const request = {picture: this.picture, map, shape, object, at};
      const found = await this.#solver.photoObject(request, {
        signal,
        onProgress: (progress) => {
          if (signal.aborted) return;
          this.#search = {kind: 'looking', ...progress};
          this.changedOften();
        },
      });
      if (signal.aborted) return;
      this.change({...unmeasured, object: found});
    } catch (error) {
      if (!signal.aborted) this.#found({kind: 'failed', failure: toFailure(error)});
    }
  }

  /** Cancels the search for a coin or card; earlier measurements stay. */
  cancelSearch(): void {
    if (this.#search.kind !== 'looking') return;
    this.#searches.stop();
    this.#found({kind: 'none'});
  }

  /** Sets the white balance from a white spot. */
  async whiten(at: Point): Promise<void> {
    const {step} = this;
    if (!step) return;
    const gains = await gainsAt(this.picture, step.reading, at);
    if (this.step === step) this.change({gains});
  }

  undo(): boolean {
    return this.#travel(undone);
  }

  redo(): boolean {
    return this.#travel(redone);
  }

  /**
   * Returns the print's cell at present, computed once.
   * @throws {SolverError}; an `AbortError` after a request for another cell
   */
  tile(): Promise<PhotoPixels> {
    const {step} = this;
    if (!step) throw new Error('There is nothing to make a tile of.');
    const settings = tileSettings(step);
    const key = JSON.stringify(settings);
    if (this.#made?.key === key) return this.#made.pixels;
    const {signal} = this.#tiles.begin();
    const pixels = this.#solver.photoTile({...settings, picture: this.picture}, {signal});
    const made = {key, pixels};
    this.#made = made;
    pixels.catch(() => {
      if (this.#made === made) this.#made = undefined; // the next call tries again
    });
    return pixels;
  }

  override dispose(): void {
    super.dispose();
    this.#reads.stop();
    this.#tiles.stop();
    this.#searches.stop();
  }

  #travel(way: (history: History<PhotoStep>) => History<PhotoStep> | undefined): boolean {
    const history = this.#history && way(this.#history);
    if (!history) return false;
    this.#reads.stop();
    this.#searches.stop();
    this.#history = history;
    this.#become({kind: 'done'});
    return true;
  }

  #become(state: PhotoState): void {
    this.#state = state;
    this.#found({kind: 'none'});
  }

  #found(search: ObjectSearch): void {
    this.#search = search;
    this.changed();
  }

  async #read(settings: PhotoSettings): Promise<void> {
    const {signal} = this.#reads.begin();
    const isOver = (): boolean => signal.aborted;
    this.#searches.stop(); // it would measure by the old lattice
    this.#become({kind: 'reading', stage: 'repeat', fraction: 0});
    try {
      // a photo restored from storage no longer contains it
      const f35 = this.step?.f35 ?? (await focalLengthOf(this.picture));
      if (isOver()) return;
      const reading = await this.#solver.photo(
        {...settings, ...(f35 !== undefined && {f35}), picture: this.picture},
        {
          signal,
          onProgress: ({stage, fraction}) => {
            if (isOver()) return;
            this.#state = {kind: 'reading', stage, fraction};
            this.changedOften();
          },
        },
      );
      if (isOver()) return;
      const {lattice} = settings;
      const steady = lattice ? steadied(reading, lattice, this.step?.chosen) : reading;
      const next = stepOf(steady, this.step, {f35, isByHand: lattice !== undefined});
      this.#history = this.#history ? stepped(this.#history, next) : begun(next);
      this.#become({kind: 'done'});
    } catch (error) {
      if (!isOver()) this.#become({kind: 'failed', failure: toFailure(error)});
    }
  }
}

// Keeps the photo in the dialog until a print is made from it, for a reload of the page.

/** A photo that was in the dialog before. */
export interface PhotoBefore extends UnfinishedPhoto {
  /** True if a print was made from it. */
  readonly isFinished: boolean;
}

interface Where {
  readonly keeper: PhotoKeeper | undefined;
  /** Image of the design's print. */
  readonly image: string;
}

export class UnfinishedWork {
  readonly #where: () => Where;
  /** State as kept; undefined if nothing of the present photo is kept. */
  #kept: {readonly history: History<PhotoStep> | undefined; readonly name: string} | undefined;

  constructor(where: () => Where) {
    this.#where = where;
  }

  /** Keeps a changed state. */
  keep({picture, history}: PhotoSession, name: string): void {
    const {keeper, image} = this.#where();
    if (this.#kept?.history === history && this.#kept?.name === name) return;
    this.#kept = {history, name};
    void keeper?.keepUnfinished(image, {picture, name, history});
  }

  /** Marks a restored state as kept. */
  resume({history}: PhotoSession, name: string): void {
    this.#kept = {history, name};
  }

  /** Prepares for another photo in the dialog. */
  leave(): void {
    this.#kept = undefined;
  }

  /** Discards the kept photo for good. */
  drop(): void {
    if (this.#kept) void this.#where().keeper?.forgetUnfinished();
    this.leave();
  }

  /**
   * Finds the photo to continue with: the unfinished one of this print; else the one that this
   * print was made from; else the unfinished one of another print.
   * @param isLeft the dialog itself holds the unfinished photo
   */
  async find(isLeft: boolean): Promise<PhotoBefore | undefined> {
    const {keeper, image} = this.#where();
    const left = isLeft ? undefined : await keeper?.unfinished(image);
    const isMade = image.startsWith('data:') && !left?.isOfPrint;
    const made = isMade ? await keeper?.kept(image) : undefined;
    if (made) return {...made, history: begun(made.step), isFinished: true};
    return left && {...left, isFinished: false};
  }
}
