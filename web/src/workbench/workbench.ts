/**
 * Model of a page or element: a design with its history, and the solver's results. It consists of
 * parts that can be observed separately. Reading a property of the workbench counts as reading its
 * part.
 */
import type {Design, DesignGarment} from '../model/design/design.js';
import type {GarmentDocument} from '../model/garment/garment-document.js';
import type {Alignment} from '../model/geometry/vectors.js';
import {begun, type History} from '../model/design/history.js';
import type {Progress} from '../model/design/solve-problem.js';
import type {MeshedPattern, SolveResult} from '../model/result/result.js';
import type {DetectedSymmetry, MeasuredSymmetry, Symmetry} from '../model/garment/symmetries.js';
import {leaseSolver, type SolverLease} from '../solver/pool.js';
import type {SolverService} from '../solver/service.js';
import type {Tile} from '../image/tile.js';
import {tileOf} from '../image/print-tile.js';
import {preferencesFor, type Preferences} from '../texts/preferences.js';
import type {Afterwards} from './afterwards.js';
import {ChosenPreferences} from './chosen-preferences.js';
import {DesignHistory} from './design-history.js';
import {Notices} from './notices.js';
import {Observable} from './observable.js';
import {RunningSolve} from './running-solve.js';
import {bareCloth, newDesign} from './samples.js';
import type {Scenes} from './scenes.js';
import {Selection} from './selection.js';
import {ShownSheet} from './shown-sheet.js';
import {Solving} from './solving.js';
import type {DoubtfulPicture, Notice, SheetWindow, SolveState, Step, Target} from './state.js';

export type * from './state.js';

interface WorkbenchOptions {
  /** Receives every progress report of a solve; other parts receive them at a limited rate. */
  readonly progress?: (progress: Progress) => void;
  /** Loads the image of a print's cell by its URL; without an image the fabric is bare. */
  readonly tileOf?: (image: string, signal?: AbortSignal) => Promise<Tile | undefined>;
}

/** Parts that can be observed separately. */
export interface WorkbenchParts {
  readonly preferences: ChosenPreferences;
  readonly notices: Notices;
  readonly selection: Selection;
  readonly sheet: ShownSheet;
  readonly history: DesignHistory;
  readonly running: RunningSolve;
  readonly solving: Solving;
  readonly afterwards: Afterwards;
}

export class Workbench {
  readonly solver: SolverService;
  readonly tileOf: NonNullable<WorkbenchOptions['tileOf']>;
  readonly #parts: WorkbenchParts;
  readonly #lease: SolverLease;

  /** @param lease lease that `dispose` ends */
  constructor(
    lease: SolverLease = leaseSolver(),
    chosen = preferencesFor(navigator.language),
    {progress, tileOf: read = tileOf}: WorkbenchOptions = {},
  ) {
    this.solver = lease.solver;
    this.#lease = lease;
    this.tileOf = read;
    const preferences = new ChosenPreferences(chosen);
    const [notices, selection, sheet] = [new Notices(), new Selection(), new ShownSheet()];
    const running = new RunningSolve();
    const history = new DesignHistory(sheet, {
      mended: (design) => solving.mended(design),
      arrived: () => {
        notices.say(undefined);
        solving.arrive();
      },
    });
    const known = {preferences, notices, selection, running, history};
    const solving: Solving = new Solving(lease.solver, known, progress);
    this.#parts = {...known, sheet, solving, afterwards: solving.afterwards};
  }

  /**
   * Calls back after changes of some parts, once if several change together.
   * @returns the function that ends this
   */
  subscribe(parts: readonly (keyof WorkbenchParts)[], listener: () => void): () => void {
    const ends = parts.map((name) => this.#parts[name].subscribe(listener));
    return () => {
      for (const end of ends) end();
    };
  }

  get preferences(): Preferences {
    return this.#parts.preferences.read.preferences;
  }

  prefer(change: Partial<Preferences>): void {
    const {preferences, solving} = this.#parts;
    const wasOff = !preferences.preferences.solveAsIGo;
    preferences.prefer(change);
    if (wasOff && change.solveAsIGo && solving.state.kind === 'stale') solving.align();
  }

  get notice(): Notice | undefined {
    return this.#parts.notices.read.notice;
  }

  say(notice: Notice | undefined): void {
    this.#parts.notices.say(notice);
  }

  /** Image that needs a decision before it becomes the print. */
  get doubtful(): DoubtfulPicture | undefined {
    return this.#parts.notices.read.doubtful;
  }

  set doubtful(picture: DoubtfulPicture | undefined) {
    this.#parts.notices.doubtful = picture;
  }

  /** The part that was picked last; it stays when the pointer moves on. */
  get selected(): Target | undefined {
    return this.#parts.selection.read.selected;
  }

  select(target: Target | undefined): void {
    this.#parts.selection.select(target);
  }

  /** The part under the pointer, in the drawing or in a list. */
  get pointed(): Target | undefined {
    return this.#parts.selection.read.pointed;
  }

  point(target: Target | undefined): void {
    this.#parts.selection.point(target);
  }

  /** Window of the sheet, with its view and images; set by the code that draws it. */
  get view(): SheetWindow | undefined {
    return this.#parts.sheet.view;
  }

  set view(view: SheetWindow | undefined) {
    this.#parts.sheet.view = view;
  }

  /** Sheets of the pattern on display, for all other views of the same garment. */
  get scenes(): Scenes | undefined {
    return this.#parts.sheet.read.scenes;
  }

  set scenes(scenes: Scenes | undefined) {
    this.#parts.sheet.scenes = scenes;
  }

  /** Undefined until there is a garment. */
  get design(): Design | undefined {
    return this.#parts.history.read.design;
  }

  get history(): History<Step> | undefined {
    return this.#parts.history.read.history;
  }

  /** Number of histories that were begun; a new number means different work. */
  get beginnings(): number {
    return this.#parts.history.read.beginnings;
  }

  get canUndo(): boolean {
    return this.#parts.history.read.canUndo;
  }

  get canRedo(): boolean {
    return this.#parts.history.read.canRedo;
  }

  /** True during a drag, whose changes are one step. */
  get isHeld(): boolean {
    return this.#parts.history.read.isHeld;
  }

  /** Starts, or starts over, with another history. */
  begin(history: History<Step>): void {
    this.#parts.history.begin(history);
  }

  /**
   * Takes a step.
   * @param kind kind of change; changes of one kind in quick succession are one step
   */
  change(change: Partial<Design>, kind?: string): void {
    this.#parts.history.change(change, kind);
  }

  /**
   * Takes a step to an edited garment.
   * @param document content of its file
   * @param pattern its pattern until it is meshed
   */
  edit(
    change: Partial<Design> & Pick<Design, 'garment'>,
    document: GarmentDocument,
    pattern: MeshedPattern,
  ): void {
    this.#parts.solving.expect(change.garment, document, pattern);
    this.change(change);
  }

  /**
   * Begins a drag. Until it ends, its changes are one step, however long it pauses.
   * @returns the function that ends it
   */
  hold(): () => void {
    return this.#parts.history.hold();
  }

  undo(): void {
    this.#parts.history.undo();
  }

  redo(): void {
    this.#parts.history.redo();
  }

  get state(): SolveState {
    return this.#parts.solving.read.state;
  }

  /** The garment document; undefined until the file has been read. */
  get garment(): GarmentDocument | undefined {
    return this.#parts.solving.read.garment;
  }

  /** Progress of the running or the last solve. */
  get progress(): Progress {
    return this.#parts.running.read.progress;
  }

  /** Alignments of the pieces of `pattern` in the intermediate result. */
  get partial(): readonly Alignment[] | undefined {
    return this.#parts.running.read.partial;
  }

  /** The meshed garment, with the symmetries of the last solve that was started. */
  get pattern(): MeshedPattern | undefined {
    return this.#parts.solving.read.pattern;
  }

  /** The result of the present design, if there is one. */
  get result(): SolveResult | undefined {
    return this.#parts.solving.read.result;
  }

  /** Requested symmetries; with `auto`, those that the result keeps. */
  get kept(): readonly Symmetry[] {
    return this.#parts.solving.read.kept;
  }

  /** Detected symmetries that are not kept yet. */
  get found(): readonly DetectedSymmetry[] {
    return this.#parts.solving.read.found;
  }

  /** Work after a solve. */
  get afterwards(): Afterwards {
    return this.#parts.afterwards.read;
  }

  /**
   * True if the user can edit the design. Otherwise no symmetries are detected, and there is no
   * work after a solve.
   */
  set isEdited(isEdited: boolean) {
    this.#parts.solving.isEdited = isEdited;
  }

  /** Starts without a garment. */
  beginEmpty(): void {
    this.#parts.solving.beEmpty();
  }

  /**
   * Begins with another garment in the present print, once it has been read.
   * @throws {SolverError} and changes nothing
   */
  async open(garment: DesignGarment): Promise<void> {
    const {history, solving} = this.#parts;
    const fresh = newDesign(garment, history.design?.print ?? bareCloth);
    const [pattern] = await Promise.all([solving.meshed(fresh), solving.documentOf(garment)]);
    const {method, fabric} = history.design ?? fresh;
    const design = {...fresh, method, ...(fabric && {fabric})};
    Observable.together(() => {
      history.begin(begun({design, view: null}));
      solving.know(garment, pattern);
    });
  }

  /** Document of a garment, read once. @throws {SolverError} when it cannot be read */
  documentOf(garment: DesignGarment): Promise<GarmentDocument> {
    return this.#parts.solving.documentOf(garment);
  }

  /** Meshes a garment as in its file. @throws {SolverError} when it cannot be read */
  meshed(design: Pick<Design, 'garment' | 'print'>): Promise<MeshedPattern> {
    return this.#parts.solving.meshed(design);
  }

  /** Solves the present design, whatever is running. */
  align(): void {
    this.#parts.solving.align();
  }

  cancel(): void {
    this.#parts.solving.cancel();
  }

  /** Measures a symmetry on the present garment. @throws {SolverError} */
  measure(symmetry: Symmetry, signal?: AbortSignal): Promise<MeasuredSymmetry> {
    return this.#parts.solving.measure(symmetry, signal);
  }

  dispose(): void {
    this.#lease.release();
    for (const part of Object.values(this.#parts) as Observable[]) part.dispose();
  }
}
