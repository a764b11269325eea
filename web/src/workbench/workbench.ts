/** What a page or element works on: a design with its history, and what the solver knows of it. */
import {askedSymmetries, printOf, type Design, type DesignGarment} from '../model/design.js';
import type {Alignment} from '../model/geometry.js';
import type {Failure} from '../model/failure.js';
import {begun} from '../model/history.js';
import {mirroringsOf} from '../model/pins.js';
import type {Progress} from '../model/problem.js';
import type {MeshedPattern, SolveResult} from '../model/result.js';
import type {DetectedSymmetry, MeasuredSymmetry, Symmetry} from '../model/symmetries.js';
import {leaseSolver, type SolverLease} from '../solver/pool.js';
import type {SolverService} from '../solver/service.js';
import type {Tile} from '../recognition/tile.js';
import {tileOf} from '../recognition/print-tile.js';
import {textsOf} from '../texts/texts.js';
import {Afterwards} from './afterwards.js';
import {FoundSymmetries} from './found-symmetries.js';
import {DesignHistory} from './design-history.js';
import {KnownGarment} from './known-garment.js';
import {LatestSolve} from './latest-solve.js';
import {askedOf, measuredMirrorings, withKeptPins} from './kept-pins.js';
import {preferencesFor, type Preferences} from '../texts/preferences.js';
import {ResultCache} from './result-cache.js';
import {bareCloth, newDesign} from './samples.js';
import type {SolveState} from './state.js';
import {improving} from './steps.js';

export type * from './state.js';

export interface WorkbenchOptions {
  /** Hears all that the solver says of a solve, of which the rest is told at a slower pace. */
  readonly progress?: (progress: Progress) => void;
  /** The picture of a print's cell, by its URL; none shows bare cloth. */
  readonly tileOf?: (image: string, signal?: AbortSignal) => Promise<Tile | undefined>;
}

export class Workbench extends DesignHistory {
  readonly solver: SolverService;
  readonly tileOf: NonNullable<WorkbenchOptions['tileOf']>;
  /** What is worked on once an answer is there. */
  readonly afterwards: Afterwards;
  readonly #lease: SolverLease;
  readonly #results = new ResultCache();
  readonly #solve: LatestSolve;
  readonly #found: FoundSymmetries;
  readonly #known = new KnownGarment();
  #state: SolveState = {kind: 'opening'};
  /** What the solver broke on, and was begun anew. */
  #retried: Design | undefined;
  #isEdited = true;

  /** @param lease given back by `dispose` */
  constructor(
    lease: SolverLease = leaseSolver(),
    preferences = preferencesFor(navigator.language),
    {progress, tileOf: read = tileOf}: WorkbenchOptions = {},
  ) {
    super(preferences);
    this.solver = lease.solver;
    this.#lease = lease;
    this.tileOf = read;
    const changed = (): void => {
      this.changed();
    };
    this.afterwards = new Afterwards(this.solver, {
      changed,
      improved: (design, effort, result) => this.#improved(design, effort, result),
    });
    this.#found = new FoundSymmetries(this.solver, changed);
    this.#solve = new LatestSolve(this.solver, {
      pattern: (design, pattern) => {
        if (this.#known.take(design.garment, pattern)) this.changedNext();
      },
      partial: (design, alignments) => {
        if (this.#known.lay(design.garment, alignments)) this.changedOften();
      },
      progress: (_, told) => {
        this.#state = {kind: 'solving', ...told};
        progress?.(told);
        this.changedOften();
      },
      done: (design, result) => {
        if (design !== this.design) return;
        this.#keep(design, result);
        this.#state = {kind: 'done'};
        this.#follow();
        this.changedNext();
      },
      failed: (design, failure) => {
        if (design !== this.design) return;
        if (failure.code === 'internal' && design !== this.#retried) {
          this.#retried = design;
          const {language, messages} = this.preferences;
          this.say({tone: 'info', text: textsOf(language, messages).progress.restarted});
          this.align();
          return;
        }
        if (failure.code === 'symmetryConflict' && design.options.pins)
          void this.#snap(design, failure);
        else this.#fail(design, failure);
      },
    });
  }

  get state(): SolveState {
    return this.#state;
  }

  /** The garment meshed, with the symmetries of the last solve that was begun. */
  get pattern(): MeshedPattern | undefined {
    return this.#known.pattern;
  }

  /** The answer to the present design, or to none. */
  get result(): SolveResult | undefined {
    return this.design && this.#results.of(this.design)?.result;
  }

  /** How the pieces lie in the answer that is on its way; of `pattern`'s pieces. */
  get partial(): readonly Alignment[] | undefined {
    return this.#known.partial;
  }

  /** Symmetries that are asked for; with `auto`, those that the answer keeps. */
  get kept(): readonly Symmetry[] {
    const {design, pattern} = this;
    if (!design) return [];
    return design.symmetry === 'auto' && pattern
      ? this.#found.heldBy(pattern)
      : askedSymmetries(design);
  }

  /** Symmetries the garment shows by itself and that are not kept yet. */
  get found(): readonly DetectedSymmetry[] {
    return this.#found.beside(this.kept);
  }

  override prefer(change: Partial<Preferences>): void {
    const wasOff = !this.preferences.solveAsIGo;
    super.prefer(change);
    if (wasOff && change.solveAsIGo && this.#state.kind === 'stale') this.align();
  }

  /** Whether somebody is going to ask for symmetries and what they cost: otherwise neither is looked for. */
  set isEdited(isEdited: boolean) {
    if (isEdited === this.#isEdited) return;
    this.#isEdited = isEdited;
    if (!isEdited) this.afterwards.stop();
    else if (this.#known.garment) {
      this.#found.follow(this.#known.garment);
      this.#follow();
    }
  }

  /** Starts with nothing. */
  beginEmpty(): void {
    this.#state = {kind: 'empty'};
    this.changed();
  }

  /**
   * Begins with another garment in the present print, once it has been read.
   * @throws {SolverError} and leaves everything as it is
   */
  async open(garment: DesignGarment): Promise<void> {
    const design = newDesign(garment, this.design?.print ?? bareCloth);
    const pattern = await this.meshed(design);
    const method = this.design?.method ?? design.method;
    this.begin(begun({design: {...design, method}, view: null}));
    this.#known.takeFirst(garment, pattern);
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
    this.afterwards.stop();
    this.#state = {kind: 'solving', phase: 'preparation', fraction: 0};
    this.#solve.start(this.design);
    this.changed();
  }

  cancel(): void {
    if (!this.#solve.isRunning) return;
    this.#solve.cancel();
    this.#known.rest();
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

  protected override stepped(): void {
    const {design, pattern} = this;
    if (!design?.options.pins || !pattern) return;
    const known = mirroringsOf(pattern);
    const held = design.symmetry === 'auto' ? known : askedOf(design, known);
    this.steps.mend(withKeptPins(design, pattern, held));
  }

  /** All better answers that are found in one go are one step. */
  #improved(design: Design, effort: number, result: SolveResult): Design {
    const options = {...design.options, effort};
    this.steps.change({options}, improving, this.view?.get() ?? null);
    const present = this.design ?? design;
    this.#keep(present, result);
    this.changed();
    return present;
  }

  #keep(design: Design, result: SolveResult): void {
    const {pattern} = this;
    if (pattern) this.#results.keep(design, {pattern, result});
  }

  protected override arrive(): void {
    const {design} = this;
    if (!design) return;
    this.afterwards.stop();
    if (this.#known.meet(design.garment)) this.#met(design.garment);
    const known = this.#results.of(design);
    if (known ?? !this.preferences.solveAsIGo) {
      this.#solve.cancel();
      this.#known.rest();
    }
    if (known) {
      this.#known.take(design.garment, known.pattern);
      this.#state = {kind: 'done'};
      this.#follow();
    } else if (this.preferences.solveAsIGo) {
      this.align();
    } else {
      this.#state = {kind: 'stale', cancelled: false};
    }
    this.changed();
  }

  #fail(design: Design, failure: Failure): void {
    this.#state = {kind: 'failed', failure};
    // without the module, asking once more would only make the next attempt share this one's end
    if (!this.pattern && failure.code !== 'no-wasm') void this.#showUnsolved(design);
    this.changed();
  }

  /** Pins that a symmetry is against go to the nearest places that are not, as a part of the step that led there. */
  async #snap(design: Design, failure: Failure): Promise<void> {
    const known = await measuredMirrorings(design, (symmetry) => this.measure(symmetry));
    if (design !== this.design) return;
    const next = withKeptPins(design, this.pattern, known);
    if (next === design) {
      this.#fail(design, failure);
      return;
    }
    const {language, messages} = this.preferences;
    this.steps.mend(next);
    this.arrive();
    this.say({tone: 'info', text: textsOf(language, messages).symmetry.snapped});
  }

  /** What cannot be solved may still be shown. */
  async #showUnsolved(design: Design): Promise<void> {
    const pattern = await this.meshed(design).catch(() => undefined);
    if (pattern && this.#known.takeFirst(design.garment, pattern)) this.changed();
  }

  /** A garment that was not there before. */
  #met(garment: DesignGarment): void {
    this.clearTargets();
    if (this.#isEdited) this.#found.follow(garment);
    else this.#found.forget();
  }

  #follow(): void {
    const {design, result} = this;
    if (this.#isEdited && design && result) void this.afterwards.follow(design, result);
  }
}
