/** What a page or element works on: a design with its history, and what the solver knows of it. */
import {printOf, problemOf, type Design, type DesignGarment} from '../../model/design.js';
import type {Alignment} from '../../model/geometry.js';
import {amended, redone, stepped, undone, type History} from '../../model/history.js';
import type {Problem} from '../../model/problem.js';
import type {MeshedPattern, Metrics, SolveResult} from '../../model/result.js';
import type {DetectedSymmetry, MeasuredSymmetry, Symmetry} from '../../model/symmetries.js';
import {leaseSolver, type SolverLease} from '../../solver/pool.js';
import type {SolverService} from '../../solver/service.js';
import {alignmentsFrom} from '../../viewer/scene.js';
import type {Tile} from '../../viewer/tile.js';
import {tileOf} from '../pattern/tile.js';
import {textsOf} from '../texts/texts.js';
import {Comparison} from './comparison.js';
import {lastOf} from './last-of.js';
import {LatestSolve} from './latest-solve.js';
import {Observable} from './observable.js';
import {preferencesFor, type Preferences} from './preferences.js';
import {ResultCache} from './result-cache.js';
import {bareCloth, newDesign} from './samples.js';
import type {Scenes} from './scenes.js';
import {
  sameTarget,
  type Notice,
  type SheetWindow,
  type SolveState,
  type Step,
  type Target,
} from './state.js';
import {concernsSame} from './symmetry-steps.js';

export type * from './state.js';

export interface WorkbenchOptions {
  /** What the solver is asked for a design. */
  readonly problemOf?: (design: Design) => Problem;
  /** The picture of a print's cell, by its URL; none shows bare cloth. */
  readonly tileOf?: (image: string, signal?: AbortSignal) => Promise<Tile | undefined>;
}

export class Workbench extends Observable {
  readonly solver: SolverService;
  readonly tileOf: NonNullable<WorkbenchOptions['tileOf']>;
  /** Asked for the view when a step is taken, and told when one is to be restored; the page sets it. */
  view: SheetWindow | undefined;
  readonly #lease: SolverLease;
  readonly #results = new ResultCache();
  readonly #unasked = lastOf(
    (found: readonly DetectedSymmetry[], asked: readonly Symmetry[] = []) =>
      found.filter((one) => !asked.some((other) => concernsSame(one, other))),
  );
  readonly #solve: LatestSolve;
  readonly #comparison: Comparison;
  #history: History<Step> | undefined;
  #preferences: Preferences;
  #pattern: MeshedPattern | undefined;
  /** What `#found` is about. */
  #garment: DesignGarment | undefined;
  #found: readonly DetectedSymmetry[] = [];
  #partial: readonly Alignment[] | undefined;
  #state: SolveState = {kind: 'opening'};
  #notice: Notice | undefined;
  /** What the solver broke on, and was begun anew. */
  #retried: Design | undefined;
  #scenes: Scenes | undefined;
  #isEdited = true;
  #selected: Target | undefined;
  #pointed: Target | undefined;
  /** The kind of change that may still be amended, and until when. */
  #amendable = {kind: '', until: 0};

  /** @param lease given back by `dispose` */
  constructor(
    lease: SolverLease = leaseSolver(),
    preferences = preferencesFor(navigator.language),
    {problemOf: asked = problemOf, tileOf: read = tileOf}: WorkbenchOptions = {},
  ) {
    super();
    this.solver = lease.solver;
    this.#lease = lease;
    this.#preferences = preferences;
    this.tileOf = read;
    this.#comparison = new Comparison(this.solver, asked, () => {
      this.changed();
    });
    this.#solve = new LatestSolve(this.solver, asked, {
      pattern: (design, pattern) => {
        if (design.garment !== this.#garment) return;
        this.#pattern = pattern;
        this.#partial = undefined;
        this.changedNext();
      },
      partial: (design, alignments) => {
        if (design.garment !== this.#garment) return;
        this.#partial = alignmentsFrom(alignments);
        this.changedOften();
      },
      progress: (_, progress) => {
        this.#state = {kind: 'solving', ...progress};
        this.changedOften();
      },
      done: (design, result) => {
        if (design !== this.design) return;
        if (this.#pattern) this.#results.keep(design, {pattern: this.#pattern, result});
        this.#state = {kind: 'done'};
        this.#compare();
        this.changedNext();
      },
      failed: (design, failure) => {
        if (design !== this.design) return;
        if (failure.code === 'internal' && design !== this.#retried) {
          this.#retried = design;
          this.#notice = {
            tone: 'info',
            text: textsOf(this.#preferences.language, this.#preferences.messages).progress
              .restarted,
          };
          this.align();
          return;
        }
        this.#state = {kind: 'failed', failure};
        if (!this.#pattern) void this.#showUnsolved(design);
        this.changed();
      },
    });
  }

  /** Undefined until a garment is there. */
  get design(): Design | undefined {
    return this.#history?.present.design;
  }

  get history(): History<Step> | undefined {
    return this.#history;
  }

  get canUndo(): boolean {
    return (this.#history?.past.length ?? 0) > 0;
  }

  get canRedo(): boolean {
    return (this.#history?.future.length ?? 0) > 0;
  }

  get preferences(): Preferences {
    return this.#preferences;
  }

  get state(): SolveState {
    return this.#state;
  }

  /** The garment meshed, with the symmetries of the last solve that was begun. */
  get pattern(): MeshedPattern | undefined {
    return this.#pattern;
  }

  /** The answer to the present design, or to none. */
  get result(): SolveResult | undefined {
    return this.design && this.#results.of(this.design)?.result;
  }

  /** How the pieces lie in the answer that is on its way; of `pattern`'s pieces. */
  get partial(): readonly Alignment[] | undefined {
    return this.#partial;
  }

  /** Symmetries the garment shows by itself and nobody has asked for yet. */
  get found(): readonly DetectedSymmetry[] {
    return this.#unasked(this.#found, this.design?.symmetries);
  }

  /** What the present design reaches without its symmetries, if it has any. */
  get withoutSymmetry(): Metrics | undefined {
    return this.design && this.#comparison.of(this.design);
  }

  get notice(): Notice | undefined {
    return this.#notice;
  }

  say(notice: Notice | undefined): void {
    this.#notice = notice;
    this.changed();
  }

  prefer(change: Partial<Preferences>): void {
    const wasOff = !this.#preferences.solveAsIGo;
    this.#preferences = {...this.#preferences, ...change};
    if (wasOff && change.solveAsIGo && this.#state.kind === 'stale') this.align();
    this.changed();
  }

  /** The sheets that the pattern shows, for everything beside it that speaks of the same. */
  get scenes(): Scenes | undefined {
    return this.#scenes;
  }

  set scenes(scenes: Scenes | undefined) {
    if (scenes?.now === this.#scenes?.now && scenes?.before === this.#scenes?.before) return;
    this.#scenes = scenes;
    this.changed();
  }

  /** What was picked last: it stays when the pointer moves on. */
  get selected(): Target | undefined {
    return this.#selected;
  }

  select(target: Target | undefined): void {
    if (sameTarget(target, this.#selected)) return;
    this.#selected = target;
    this.changed();
  }

  /** What the pointer is over, in the picture or in a list. */
  get pointed(): Target | undefined {
    return this.#pointed;
  }

  point(target: Target | undefined): void {
    if (sameTarget(target, this.#pointed)) return;
    this.#pointed = target;
    this.changed();
  }

  /** Whether somebody is going to ask for symmetries and what they cost: otherwise neither is looked for. */
  set isEdited(isEdited: boolean) {
    if (isEdited === this.#isEdited) return;
    this.#isEdited = isEdited;
    if (!isEdited) this.#comparison.stop();
    else if (this.#garment) {
      this.#find(this.#garment);
      this.#compare();
    }
  }

  /** Starts with nothing. */
  beginEmpty(): void {
    this.#state = {kind: 'empty'};
    this.changed();
  }

  /** Starts, or starts over, with a history of its own. */
  begin(history: History<Step>): void {
    this.#travel(history);
  }

  /**
   * Takes a step. Changes of one `kind` that follow each other quickly, as a slider's or a drag's do,
   * are one step.
   */
  change(change: Partial<Design>, kind = ''): void {
    if (!this.#history) return;
    const design = {...this.#history.present.design, ...change};
    const view = this.view?.get() ?? null;
    const now = performance.now();
    const amends = kind !== '' && kind === this.#amendable.kind && now < this.#amendable.until;
    this.#amendable = {kind, until: now + 1000};
    const seen = amended(this.#history, {...this.#history.present, view});
    this.#history = amends ? amended(seen, {design, view}) : stepped(seen, {design, view});
    this.#notice = undefined;
    this.#arrive();
  }

  /** Takes another design as a whole; the first one begins a history. */
  replace(design: Design): void {
    if (this.#history) this.change(design);
    else this.begin({past: [], present: {design, view: null}, future: []});
  }

  undo(): void {
    this.#travel(this.#history && undone(this.#history));
  }

  redo(): void {
    this.#travel(this.#history && redone(this.#history));
  }

  /**
   * Puts another garment in the place of the present one, once it has been read.
   * @throws {SolverError} and leaves everything as it is
   */
  async open(garment: DesignGarment): Promise<void> {
    const design = newDesign(garment, this.design?.print ?? bareCloth);
    const pattern = await this.meshed(design);
    this.replace({...design, method: this.design?.method ?? design.method});
    this.#pattern ??= pattern;
    this.changed();
  }

  /** A garment as it lies in its file. @throws {SolverError} when it cannot be read */
  meshed({garment, print}: Pick<Design, 'garment' | 'print'>): Promise<MeshedPattern> {
    const problem = {garment: garment.text, print: printOf(print), symmetry: 'none'};
    return this.solver.prepare(problem, {names: {garment: garment.name}});
  }

  /** Solves the present design, whatever is under way. */
  align(): void {
    if (!this.design) return;
    this.#comparison.stop();
    this.#state = {kind: 'solving', phase: 'alignment', fraction: 0};
    this.#solve.start(this.design);
    this.changed();
  }

  cancel(): void {
    if (!this.#solve.isRunning) return;
    this.#solve.cancel();
    this.#partial = undefined;
    this.#state = {kind: 'stale', cancelled: true};
    this.changed();
  }

  /** How well a symmetry fits the present garment. @throws {SolverError} */
  measure(symmetry: Symmetry, signal?: AbortSignal): Promise<MeasuredSymmetry> {
    const {text, name} = this.design?.garment ?? {text: '', name: ''};
    return this.solver.mirror(text, symmetry, {name, ...(signal && {signal})});
  }

  override dispose(): void {
    this.#lease.release();
    super.dispose();
  }

  #travel(history: History<Step> | undefined): void {
    if (!history) return;
    this.#history = history;
    this.#amendable = {kind: '', until: 0};
    this.#notice = undefined;
    this.#arrive();
    if (history.present.view) this.view?.set(history.present.view);
  }

  /** The present design may be any other than before. */
  #arrive(): void {
    const {design} = this;
    if (!design) return;
    this.#comparison.stop();
    if (design.garment !== this.#garment) this.#meet(design.garment);
    const known = this.#results.of(design);
    if (known ?? !this.#preferences.solveAsIGo) {
      this.#solve.cancel();
      this.#partial = undefined;
    }
    if (known) {
      this.#pattern = known.pattern;
      this.#state = {kind: 'done'};
      this.#compare();
    } else if (this.#preferences.solveAsIGo) {
      this.align();
    } else {
      this.#state = {kind: 'stale', cancelled: false};
    }
    this.changed();
  }

  /** What cannot be solved may still be shown. */
  async #showUnsolved(design: Design): Promise<void> {
    const {garment, print} = design;
    const problem = {garment: garment.text, print: printOf(print), symmetry: 'none'};
    const pattern = await this.solver.prepare(problem).catch(() => undefined);
    if (!pattern || this.#garment !== garment || this.#pattern) return;
    this.#pattern = pattern;
    this.changed();
  }

  /** A garment that was not there before; what was known of another is forgotten. */
  #meet(garment: DesignGarment): void {
    this.#garment = garment;
    this.#pattern = undefined;
    this.#partial = undefined;
    this.#found = [];
    this.#selected = undefined;
    this.#pointed = undefined;
    if (this.#isEdited) this.#find(garment);
  }

  #compare(): void {
    const {design, result} = this;
    if (this.#isEdited && design && result) this.#comparison.follow(design, result.metrics);
  }

  #find(garment: DesignGarment): void {
    this.solver.symmetries(garment.text, {name: garment.name}).then(
      ({symmetries}) => {
        if (this.#garment !== garment) return;
        this.#found = symmetries;
        this.changed();
      },
      () => undefined, // a garment that cannot be read fails to solve as well, and that is said
    );
  }
}
