/** One garment in one print, from its files to the answer: what the element shows, without the element. */
import {fabricOf, type Design} from '../../model/design.js';
import type {FabricName} from '../../model/drape.js';
import {SolverError, type Failure} from '../../model/failure.js';
import type {SolveResult} from '../../model/result.js';
import {writeStoredDesign, type StoredDesign} from '../../model/stored-design.js';
import type {LeasePlaces} from '../../solver/pool.js';
import {textsOf, type Texts} from '../../texts/texts.js';
import {lastOf} from '../../workbench/last-of.js';
import type {Preferences} from '../../texts/preferences.js';
import {spokenError} from '../../workbench/spoken-failure.js';
import {Workbench} from '../../workbench/workbench.js';
import {Announcer, type Emit} from './announcer.js';
import {asError} from './as-error.js';
import type {GarmentState} from './events.js';
import type {FileWords} from './files.js';
import {LastingSolver} from './lasting-solver.js';
import {nextDesign, type Answered, type ReadGarments} from './next-design.js';
import {storedDesign} from './stored.js';
import {restored} from './restored.js';
import {Sources, type Asked, type Loaded} from './sources.js';
import {ToldTiles} from './told-tiles.js';
import {Waiting} from './waiting.js';

/** Whoever has the session. */
interface SessionOwner {
  readonly places: () => LeasePlaces;
  readonly emit: Emit;
  /** State, result or design may be others than before. */
  readonly changed: () => void;
}

/** Why something is loaded. */
export interface LoadReason {
  /** What is to be restored of it. */
  readonly stored?: StoredDesign | undefined;
  readonly byUser?: boolean;
}

const states: Readonly<Record<Workbench['state']['kind'], GarmentState>> = {
  ...{opening: 'idle', empty: 'idle', stale: 'stale', solving: 'solving'},
  ...{done: 'ready', failed: 'error'},
};

/** What state, errors and events depend on: what is said of pieces calls them as the sheet does. */
const heard = ['history', 'solving', 'running', 'selection', 'sheet', 'preferences'] as const;

export class GarmentSession {
  readonly workbench: Workbench;
  readonly #owner: SessionOwner;
  readonly #tell: Announcer;
  readonly #lease: LastingSolver;
  readonly #sources = new Sources(() => this.#words);
  /** Remembered: it takes the sha256 of the whole result, and is asked for at every change of the workbench. */
  readonly #storedText = lastOf((design: Design, result: SolveResult) =>
    writeStoredDesign(storedDesign(design, result, this.#words)),
  );
  readonly #waiting = new Waiting<SolveResult>();
  #loading: AbortController | undefined;
  /** Why the files could not be loaded. */
  #failure: SolverError | undefined;
  /** Something else is asked for, and nobody is loading it. */
  #isOutdated = false;
  #last: Answered | undefined;
  /** As the program has it; any other is the user's. */
  #given: Design | undefined;
  #isTouched = false;
  /** What was told last of a drag. */
  #told: Design | undefined;

  constructor(owner: SessionOwner, preferences: Preferences) {
    this.#owner = owner;
    this.#tell = new Announcer(owner.emit, this.#spoken);
    this.#lease = new LastingSolver(owner.places);
    const tiles = new ToldTiles(
      () => this.#texts,
      (error) => {
        this.report(error);
      },
    );
    this.workbench = new Workbench(this.#lease, preferences, {
      tileOf: (image, signal) => tiles.tile(image, signal),
      progress: (progress) => {
        this.#tell.progress(progress);
      },
    });
    this.workbench.isEdited = false;
    this.workbench.subscribe(heard, () => {
      this.#follow();
    });
  }

  get state(): GarmentState {
    if (this.#loading) return 'loading';
    if (this.#isOutdated) return this.workbench.design ? 'stale' : 'idle';
    return this.#failure ? 'error' : states[this.workbench.state.kind];
  }

  get error(): SolverError | undefined {
    if (this.state !== 'error') return undefined;
    const {state} = this.workbench;
    return this.#failure ?? (state.kind === 'failed' ? this.#spoken(state.failure) : undefined);
  }

  get result(): SolveResult | undefined {
    return this.state === 'ready' ? this.workbench.result : undefined;
  }

  /** Whether a promise of an answer has not been kept yet. */
  get isAwaited(): boolean {
    return !this.#waiting.isEmpty;
  }

  get #texts(): Texts {
    const {language, messages} = this.workbench.preferences;
    return textsOf(language, messages);
  }

  readonly #spoken = (failure: Failure): SolverError =>
    spokenError(failure, this.workbench, this.#texts);

  get #words(): FileWords {
    return this.#texts.garment;
  }

  /** Something else is asked for, which is going to be loaded. */
  outdate(): void {
    this.#isOutdated = true;
    this.#owner.changed();
  }

  /**
   * Reads what is asked for, as far as it is new, and solves it. What the user has changed of the rest stays.
   * @returns whether it was read, and nothing else took its place
   */
  async load(asked: Asked, {stored, byUser = false}: LoadReason = {}): Promise<boolean> {
    this.#loading?.abort();
    const loading = new AbortController();
    this.#loading = loading;
    this.#failure = undefined;
    this.#isOutdated = false;
    this.workbench.cancel();
    if (!this.#last) this.#lease.warm(); // while the files are on their way
    this.#owner.changed();
    try {
      const loaded = await this.#sources.load(asked, loading.signal);
      const read = stored ? {} : await this.#readFor(loaded);
      if (loading.signal.aborted) return false;
      const answered = {asked, loaded};
      const design = stored
        ? restored(loaded, stored, this.#words)
        : nextDesign(answered, this.#last, this.workbench.design, read);
      this.#tell.loaded(loaded);
      if (this.#loading !== loading) return false; // whoever heard it wants something else
      this.#loading = undefined;
      this.#last = answered;
      this.#begin(design, byUser);
      return true;
    } catch (error) {
      loading.abort(); // what else is being read is not needed any more
      if (this.#loading === loading) {
        this.#loading = undefined;
        this.#fail(asError(error));
      }
      return false;
    }
  }

  /** What decides which pins stay on another garment; what cannot be read cannot be solved, which says why. */
  async #readFor({garment}: Loaded): Promise<ReadGarments> {
    const {design, garment: before} = this.workbench;
    if (!design?.options.pins || this.#last?.loaded.garment === garment) return {};
    return {before, next: await this.workbench.documentOf(garment).catch(() => undefined)};
  }

  /** What the present design is made of when it is worn: nothing is read or solved for that. */
  set fabric(fabric: FabricName) {
    const {design} = this.workbench;
    if (this.#last) this.#last = {...this.#last, asked: {...this.#last.asked, fabric}};
    if (!design || fabricOf(design) === fabric) return;
    this.workbench.change({fabric});
    this.#given = this.workbench.design;
  }

  /** As the program gave it, without what the user has changed. */
  reset(): void {
    const last = this.#last;
    this.#last = undefined; // nothing of it stays, whenever the next is loaded
    if (!last || this.#loading || this.#isOutdated || this.#failure) return;
    this.#last = last;
    this.#begin(nextDesign(last, undefined, undefined));
  }

  /** @returns whether there was anything to solve again */
  solveAgain(): boolean {
    if (this.#failure || this.#isOutdated || !this.workbench.design) return false;
    this.workbench.align();
    return true;
  }

  /**
   * The answer to what is asked for now, or to what takes its place before it is there.
   * @param left called when the last who waited has left
   */
  answer(signal: AbortSignal | undefined, left: () => void): Promise<SolveResult> {
    const answer = this.#waiting.join(signal, () => {
      if (this.#waiting.isEmpty) left();
    });
    this.#follow(); // the workbench tells of an answer a little later than it has it
    return answer;
  }

  /** Ends what is under way. What is shown stays. */
  cancel(): void {
    this.#loading?.abort();
    const wasLoading = this.#loading !== undefined;
    this.#isOutdated ||= wasLoading;
    this.#loading = undefined;
    this.workbench.cancel();
    this.#waiting.reject(new DOMException(this.#words.cancelled, 'AbortError'));
    if (wasLoading) this.#owner.changed();
  }

  /** Gives back what others may need. The last answer is kept. @returns whether something was under way */
  pause(): boolean {
    const wasBusy = ['loading', 'solving'].includes(this.state);
    this.cancel();
    this.#lease.release();
    return wasBusy;
  }

  /** @throws {SolverError} with one sentence when there is nothing to store, or no place to name */
  stored(): StoredDesign & {readonly format: string} {
    const {design, result} = this.workbench;
    if (this.state !== 'ready' || !design || !result) {
      throw new SolverError({code: 'options', message: this.#words.noAnswer});
    }
    const text = this.#storedText(design, result);
    return JSON.parse(text) as StoredDesign & {readonly format: string};
  }

  /** Says something that keeps nothing from going on. */
  report(error: SolverError): void {
    this.#tell.failed(error);
  }

  #begin(design: Design, byUser = false): void {
    this.#given = design;
    this.#isTouched = byUser;
    this.workbench.begin({past: [], present: {design, view: null}, future: []});
  }

  #fail(error: SolverError): void {
    this.#failure = error;
    this.report(error);
    this.#owner.changed();
    this.#settle();
  }

  /** The workbench has changed: by a program, by its user, or by an answer. */
  #follow(): void {
    const {workbench} = this;
    if (workbench.design !== this.#given) {
      this.#given = workbench.design;
      this.#isTouched = true;
    }
    this.#owner.changed();
    // an answer to what is not asked any more is no news
    if (!this.#loading && !this.#isOutdated) this.#tell.solved(workbench);
    if (this.state === 'ready' && this.#isTouched) this.#tellOfUser();
    this.#tell.selected(workbench);
    this.#settle();
  }

  /** Once for a whole drag, and meanwhile as something that goes on. */
  #tellOfUser(): void {
    const {isHeld, design} = this.workbench;
    if (isHeld && design === this.#told) return;
    this.#told = isHeld ? design : undefined;
    this.#isTouched = isHeld;
    this.#owner.emit(isHeld ? 'input' : 'change', {design: this.#storable()});
  }

  #storable(): StoredDesign | null {
    try {
      return this.stored();
    } catch {
      return null; // given as objects
    }
  }

  /** Everybody who waits hears what there is to be heard. */
  #settle(): void {
    const {state, result, error} = this;
    if (state === 'ready' && result) this.#waiting.resolve(result);
    else if (state === 'error') this.#waiting.reject(error);
    else if (state === 'stale' && this.workbench.state.kind === 'stale' && !this.#isOutdated) {
      this.#waiting.reject(new DOMException(this.#words.cancelled, 'AbortError'));
    }
  }
}
