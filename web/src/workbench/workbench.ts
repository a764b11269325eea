/**
 * What a page or element works on: a design with its history, and what the solver knows of it. It consists of parts
 * that can be followed one by one; whoever reads of the workbench reads of the part that has it.
 */
import type {Design, DesignGarment} from '../model/design.js';
import type {GarmentDocument} from '../model/garment-document.js';
import type {Alignment} from '../model/geometry.js';
import {begun, type History} from '../model/history.js';
import type {Progress} from '../model/problem.js';
import type {MeshedPattern, SolveResult} from '../model/result.js';
import type {DetectedSymmetry, MeasuredSymmetry, Symmetry} from '../model/symmetries.js';
import {leaseSolver, type SolverLease} from '../solver/pool.js';
import type {SolverService} from '../solver/service.js';
import type {Tile} from '../recognition/tile.js';
import {tileOf} from '../recognition/print-tile.js';
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

export interface WorkbenchOptions {
  /** Hears all that the solver says of a solve, of which the rest is told at a slower pace. */
  readonly progress?: (progress: Progress) => void;
  /** The picture of a print's cell, by its URL; none shows bare cloth. */
  readonly tileOf?: (image: string, signal?: AbortSignal) => Promise<Tile | undefined>;
}

/** What can be followed by itself. */
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

  /** @param lease given back by `dispose` */
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

  /** Calls back after changes of some parts, once where several change together. @returns what ends that */
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

  /** What has to be decided before it becomes the print. */
  get doubtful(): DoubtfulPicture | undefined {
    return this.#parts.notices.read.doubtful;
  }

  set doubtful(picture: DoubtfulPicture | undefined) {
    this.#parts.notices.doubtful = picture;
  }

  /** What was picked last: it stays when the pointer moves on. */
  get selected(): Target | undefined {
    return this.#parts.selection.read.selected;
  }

  select(target: Target | undefined): void {
    this.#parts.selection.select(target);
  }

  /** What the pointer is over, in the picture or in a list. */
  get pointed(): Target | undefined {
    return this.#parts.selection.read.pointed;
  }

  point(target: Target | undefined): void {
    this.#parts.selection.point(target);
  }

  /** Where the sheet stands, and pictures of it; whoever draws it sets it. */
  get view(): SheetWindow | undefined {
    return this.#parts.sheet.view;
  }

  set view(view: SheetWindow | undefined) {
    this.#parts.sheet.view = view;
  }

  /** The sheets that the pattern shows, for everything beside it that speaks of the same. */
  get scenes(): Scenes | undefined {
    return this.#parts.sheet.read.scenes;
  }

  set scenes(scenes: Scenes | undefined) {
    this.#parts.sheet.scenes = scenes;
  }

  /** Undefined until a garment is there. */
  get design(): Design | undefined {
    return this.#parts.history.read.design;
  }

  get history(): History<Step> | undefined {
    return this.#parts.history.read.history;
  }

  /** How many histories were begun: another number is another piece of work. */
  get beginnings(): number {
    return this.#parts.history.read.beginnings;
  }

  get canUndo(): boolean {
    return this.#parts.history.read.canUndo;
  }

  get canRedo(): boolean {
    return this.#parts.history.read.canRedo;
  }

  /** Whether a drag is under way, whose changes are one step. */
  get isHeld(): boolean {
    return this.#parts.history.read.isHeld;
  }

  /** Starts, or starts over, with a history of its own. */
  begin(history: History<Step>): void {
    this.#parts.history.begin(history);
  }

  /** Takes a step. @param kind changes of one that follow each other quickly are one step */
  change(change: Partial<Design>, kind?: string): void {
    this.#parts.history.change(change, kind);
  }

  /**
   * Takes a step to a garment that an edit has made of the present one.
   * @param document what its file holds @param pattern how it lies until it is meshed
   */
  edit(
    change: Partial<Design> & Pick<Design, 'garment'>,
    document: GarmentDocument,
    pattern: MeshedPattern,
  ): void {
    this.#parts.solving.expect(change.garment, document, pattern);
    this.change(change);
  }

  /** For a drag: until it ends, its changes are one step, however long it rests. @returns what ends it */
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

  /** The garment as its file has it; undefined until it has been read. */
  get garment(): GarmentDocument | undefined {
    return this.#parts.solving.read.garment;
  }

  /** How far the solve is that is under way. */
  get progress(): Progress {
    return this.#parts.running.read.progress;
  }

  /** How the pieces lie in the answer that is on its way; of `pattern`'s pieces. */
  get partial(): readonly Alignment[] | undefined {
    return this.#parts.running.read.partial;
  }

  /** The garment meshed, with the symmetries of the last solve that was begun. */
  get pattern(): MeshedPattern | undefined {
    return this.#parts.solving.read.pattern;
  }

  /** The answer to the present design, or to none. */
  get result(): SolveResult | undefined {
    return this.#parts.solving.read.result;
  }

  /** Symmetries that are asked for; with `auto`, those that the answer keeps. */
  get kept(): readonly Symmetry[] {
    return this.#parts.solving.read.kept;
  }

  /** Symmetries the garment shows by itself and that are not kept yet. */
  get found(): readonly DetectedSymmetry[] {
    return this.#parts.solving.read.found;
  }

  /** What is worked on once an answer is there. */
  get afterwards(): Afterwards {
    return this.#parts.afterwards.read;
  }

  /** Whether somebody is going to ask for symmetries and what they cost: otherwise neither is looked for. */
  set isEdited(isEdited: boolean) {
    this.#parts.solving.isEdited = isEdited;
  }

  /** Starts with nothing. */
  beginEmpty(): void {
    this.#parts.solving.beEmpty();
  }

  /**
   * Begins with another garment in the present print, once it has been read.
   * @throws {SolverError} and leaves everything as it is
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

  /** What the file of a garment holds, read once. @throws {SolverError} when it cannot be read */
  documentOf(garment: DesignGarment): Promise<GarmentDocument> {
    return this.#parts.solving.documentOf(garment);
  }

  /** A garment as it lies in its file. @throws {SolverError} when it cannot be read */
  meshed(design: Pick<Design, 'garment' | 'print'>): Promise<MeshedPattern> {
    return this.#parts.solving.meshed(design);
  }

  /** Solves the present design, whatever is under way. */
  align(): void {
    this.#parts.solving.align();
  }

  cancel(): void {
    this.#parts.solving.cancel();
  }

  /** How well a symmetry fits the present garment. @throws {SolverError} */
  measure(symmetry: Symmetry, signal?: AbortSignal): Promise<MeasuredSymmetry> {
    return this.#parts.solving.measure(symmetry, signal);
  }

  dispose(): void {
    this.#lease.release();
    for (const part of Object.values(this.#parts) as Observable[]) part.dispose();
  }
}
