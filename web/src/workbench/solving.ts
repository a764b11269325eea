/**
 * The solver's state for the present design: every new design is solved, and results are stored.
 */
import {askedSymmetries, printOf, type Design, type DesignGarment} from '../model/design/design.js';
import type {Failure} from '../model/base/failure.js';
import type {GarmentDocument} from '../model/garment/garment-document.js';
import {mirroringsOf} from '../model/design/pins.js';
import type {Progress} from '../model/design/solve-problem.js';
import type {MeshedPattern, SeamGroup, SolveResult} from '../model/result/result.js';
import type {DetectedSymmetry, MeasuredSymmetry, Symmetry} from '../model/garment/symmetries.js';
import {seamGroupsOf} from '../scene/group-states.js';
import type {SolverService} from '../solver/service.js';
import {Afterwards} from './afterwards.js';
import type {ChosenPreferences} from './chosen-preferences.js';
import type {DesignHistory} from './design-history.js';
import {FoundSymmetries} from './found-symmetries.js';
import {askedOf, measuredMirrorings, withKeptPins} from './kept-pins.js';
import {KnownGarment} from './known-garment.js';
import {LatestSolve} from './latest-solve.js';
import type {Notices} from './notices.js';
import {Observable} from './observable.js';
import {ResultCache} from './result-cache.js';
import type {RunningSolve} from './running-solve.js';
import type {Selection} from './selection.js';
import type {SolveState} from './state.js';

/** Parts that are read and updated. */
interface SolvingParts {
  readonly history: DesignHistory;
  readonly preferences: ChosenPreferences;
  readonly notices: Notices;
  readonly selection: Selection;
  readonly running: RunningSolve;
}

export class Solving extends Observable {
  /** Work after a solve. */
  readonly afterwards: Afterwards;
  readonly #solver: SolverService;
  readonly #parts: SolvingParts;
  readonly #results = new ResultCache();
  readonly #solve: LatestSolve;
  readonly #found: FoundSymmetries;
  readonly #known: KnownGarment;
  #state: SolveState = {kind: 'opening'};
  /** Design that was started again after the solver broke. */
  #retried: Design | undefined;
  #isEdited = true;
  #lastGroups: {readonly garment: DesignGarment; readonly groups: readonly SeamGroup[]} | undefined;

  /**
   * @param told receives every progress report of a solve; other parts receive them at a limited
   * rate
   */
  constructor(solver: SolverService, parts: SolvingParts, told?: (progress: Progress) => void) {
    super();
    this.#solver = solver;
    this.#parts = parts;
    this.afterwards = new Afterwards(solver, (design, result) => {
      const {pattern} = this;
      // other garments on the fabric have other patterns
      const isOwn = design.garment === this.#known.garment;
      if (pattern && isOwn) this.#results.keep(design, {pattern, result});
    });
    const changed = (): void => {
      this.changed();
    };
    this.#found = new FoundSymmetries(solver, changed);
    this.#known = new KnownGarment(solver, changed);
    this.#solve = new LatestSolve(solver, {
      pattern: (design, pattern) => {
        if (!this.#known.take(design.garment, pattern)) return;
        parts.running.rest();
        this.changedNext();
      },
      partial: (design, alignments) => {
        if (design.garment === this.#known.garment) parts.running.lay(alignments);
      },
      progress: (_, progress) => {
        told?.(progress);
        parts.running.proceed(progress);
      },
      done: (design, result) => {
        if (design !== this.#design) return;
        this.#keep(design, result);
        this.#state = {kind: 'done'};
        this.#follow();
        this.changedNext();
      },
      failed: (design, failure) => {
        if (design === this.#design) this.#failed(design, failure);
      },
    });
  }

  get state(): SolveState {
    return this.#state;
  }

  /** The garment document; undefined until the file has been read. */
  get garment(): GarmentDocument | undefined {
    return this.#known.document;
  }

  /** The meshed garment, with the symmetries of the last solve that was started. */
  get pattern(): MeshedPattern | undefined {
    return this.#known.pattern;
  }

  /** The result of the present design, if there is one. */
  get result(): SolveResult | undefined {
    return this.#design && this.#results.of(this.#design)?.result;
  }

  /**
   * The seams of a sewist: those of the result, or while there is none, those of the last result of
   * the present garment.
   */
  get seamGroups(): readonly SeamGroup[] {
    const {result} = this;
    if (result) return seamGroupsOf(result);
    const {garment, groups = []} = this.#lastGroups ?? {};
    return garment === this.#design?.garment ? groups : [];
  }

  /** Requested symmetries; with `auto`, those that the result keeps. */
  get kept(): readonly Symmetry[] {
    const design = this.#design;
    if (!design) return [];
    return design.symmetry === 'auto' && this.pattern
      ? this.#found.heldBy(this.pattern)
      : askedSymmetries(design);
  }

  /** Detected symmetries that are not kept yet. */
  get found(): readonly DetectedSymmetry[] {
    return this.#found.beside(this.kept);
  }

  /**
   * True if the user can edit the design. Otherwise no symmetries are detected, and there is no
   * work after a solve.
   */
  set isEdited(isEdited: boolean) {
    if (isEdited === this.#isEdited) return;
    this.#isEdited = isEdited;
    if (!isEdited) this.afterwards.stop();
    else if (this.#known.garment) {
      this.#found.follow(this.#known.garment);
      this.#follow();
    }
  }

  /** Sets the state of a workbench without a garment. */
  beEmpty(): void {
    this.#become({kind: 'empty'});
  }

  /**
   * Document of a garment that may become the present one.
   * @throws {SolverError} when it cannot be read
   */
  documentOf(garment: DesignGarment): Promise<GarmentDocument> {
    return this.#known.read(garment);
  }

  /** Stores the mesh of the present garment, if it has none yet. */
  know(garment: DesignGarment, pattern: MeshedPattern): void {
    if (this.#known.takeFirst(garment, pattern)) this.changed();
  }

  /** Prepares for the garment of an edit, which is about to become the present one. */
  expect(garment: DesignGarment, document: GarmentDocument, pattern: MeshedPattern): void {
    this.#known.expect(garment, document, pattern);
  }

  /** Meshes a garment as in its file. @throws {SolverError} when it cannot be read */
  meshed({garment, print}: Pick<Design, 'garment' | 'print'>): Promise<MeshedPattern> {
    const problem = {garment: garment.text, print: printOf(print), symmetry: 'none'};
    return this.#solver.prepare(problem, {names: {garment: garment.name}});
  }

  /** Measures a symmetry on the present garment. @throws {SolverError} */
  measure(symmetry: Symmetry, signal?: AbortSignal): Promise<MeasuredSymmetry> {
    const {text, name} = this.#design?.garment ?? {text: '', name: ''};
    return this.#solver.mirror(text, symmetry, {name, ...(signal && {signal})});
  }

  /** A design with its pins moved to places that the symmetries of its garment permit. */
  mended(design: Design): Design {
    const {pattern} = this;
    if (!design.options.pins || !pattern) return design;
    const known = mirroringsOf(pattern);
    const held = design.symmetry === 'auto' ? known : askedOf(design, known);
    return withKeptPins(design, pattern, held);
  }

  /** Solves the present design, whatever is running. */
  align(): void {
    const design = this.#design;
    if (!design) return;
    void this.#known.learn();
    Observable.together(() => {
      this.afterwards.stop();
      this.#solve.start(design);
      this.#parts.running.begin();
      this.#become({kind: 'solving'});
    });
  }

  cancel(): void {
    if (!this.#solve.isRunning) return;
    Observable.together(() => {
      this.#stop();
      this.#become({kind: 'stale', cancelled: true});
    });
  }

  /** Updates the state when the present design may have changed. */
  arrive(): void {
    Observable.together(() => {
      if (this.#design) this.#meet(this.#design);
    });
  }

  get #design(): Design | undefined {
    return this.#parts.history.design;
  }

  #become(state: SolveState): void {
    this.#state = state;
    this.changed();
  }

  #stop(): void {
    this.#solve.cancel();
    this.#parts.running.rest();
  }

  #meet(design: Design): void {
    this.afterwards.stop();
    if (this.#known.meet(design.garment)) this.#met(design.garment);
    void this.#known.learn();
    const known = this.#results.of(design);
    const {solveAsIGo} = this.#parts.preferences.chosen;
    if (!known && solveAsIGo) {
      this.align();
      return;
    }
    this.#stop();
    if (known) this.#known.take(design.garment, known.pattern);
    this.#become(known ? {kind: 'done'} : {kind: 'stale', cancelled: false});
    if (known) this.#follow();
  }

  /** Prepares for a new garment. */
  #met(garment: DesignGarment): void {
    this.#parts.selection.clear();
    this.#parts.running.rest();
    if (this.#isEdited) this.#found.follow(garment);
    else this.#found.forget();
  }

  #keep(design: Design, result: SolveResult): void {
    const {pattern} = this;
    this.#lastGroups = {garment: design.garment, groups: seamGroupsOf(result)};
    if (pattern) this.#results.keep(design, {pattern, result});
  }

  #follow(): void {
    const {result} = this;
    const design = this.#design;
    if (!this.#isEdited || !design || !result) return;
    const {history, preferences} = this.#parts;
    const {isGiven} = history.steps?.present ?? {};
    const {effort = 1} = design.options; // more than one was chosen elsewhere
    const searches = !isGiven && effort === 1 && preferences.chosen.solveAsIGo;
    void this.afterwards.follow(design, result, searches);
  }

  #failed(design: Design, failure: Failure): void {
    if (failure.code === 'internal' && design !== this.#retried) {
      this.#retried = design;
      this.#say(({progress}) => progress.restarted);
      this.align();
    } else if (failure.code === 'symmetryConflict' && design.options.pins) {
      void this.#snap(design, failure);
    } else {
      this.#fail(design, failure);
    }
  }

  #fail(design: Design, failure: Failure): void {
    this.#become({kind: 'failed', failure});
    // if the module is missing, a further request would make the next attempt share this failure
    if (!this.pattern && failure.code !== 'no-wasm') void this.#showUnsolved(design);
  }

  /**
   * Moves pins that contradict a symmetry to the nearest places that do not, as part of the step
   * that led there.
   */
  async #snap(design: Design, failure: Failure): Promise<void> {
    const known = await measuredMirrorings(design, (symmetry) => this.measure(symmetry));
    if (design !== this.#design) return;
    const next = withKeptPins(design, this.pattern, known);
    if (next === design) {
      this.#fail(design, failure);
      return;
    }
    Observable.together(() => {
      this.#parts.history.mend(next);
      this.arrive();
      this.#say(({symmetry}) => symmetry.snapped);
    });
  }

  #say(words: (texts: ChosenPreferences['texts']) => string): void {
    const {notices, preferences} = this.#parts;
    notices.say({tone: 'info', text: words(preferences.texts)});
  }

  /** Shows a design that cannot be solved. */
  async #showUnsolved(design: Design): Promise<void> {
    const pattern = await this.meshed(design).catch(() => undefined);
    if (pattern) this.know(design.garment, pattern);
  }
}
