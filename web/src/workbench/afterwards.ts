/**
 * Work after a solve, in idle time: cost of the symmetries, remedies, sizes of the print, a longer
 * search, and a bound on the alignment.
 */
import type {Design} from '../model/design/design.js';
import type {SolveResult} from '../model/result/result.js';
import type {SeamCount} from '../model/result/seam-groups.js';
import type {Remedy} from '../remedies/remedy.js';
import type {SolverService} from '../solver/service.js';
import {maySpend} from './considerate.js';
import {Comparison, Proving, RemedySearch} from './findings.js';
import {IdleSolver} from './idle-solver.js';
import {LongerSearch, type BetterMatch} from './longer-search.js';
import {Observable} from './observable.js';
import {PrintSizes, type PrintComparison} from './print-sizes.js';

type Step = () => Promise<void>;

export class Afterwards extends Observable {
  readonly #solver: IdleSolver;
  readonly #comparison: Comparison;
  readonly #remedies: RemedySearch;
  readonly #proving: Proving;
  readonly #longer: LongerSearch;
  readonly #sizes: PrintSizes;
  #latest: Design | undefined;

  /** @param keep stores a result that may be offered, so that it is shown without a solve */
  constructor(solver: SolverService, keep: (design: Design, result: SolveResult) => void) {
    super();
    const changed = (): void => {
      this.changed();
    };
    this.#solver = new IdleSolver(solver, keep);
    this.#comparison = new Comparison(solver, changed);
    this.#remedies = new RemedySearch(solver, changed);
    this.#proving = new Proving(solver, changed);
    this.#longer = new LongerSearch(this.#solver, changed);
    this.#sizes = new PrintSizes(this.#solver, changed);
  }

  /** Numbers of visible seams, and of those that match without symmetries. */
  withoutSymmetry(design: Design): SeamCount | undefined {
    return this.#comparison.of(design);
  }

  remedies(design: Design): readonly Remedy[] {
    return this.#remedies.of(design);
  }

  /**
   * Bound on the alignment: no other one has less than this share of the present one's mismatch.
   */
  bound(design: Design): number | undefined {
    return this.#proving.of(design);
  }

  /** A better answer to the design, which the user may take. */
  better(design: Design): BetterMatch | undefined {
    return this.#longer.better(design);
  }

  isSearchingLonger(design: Design): boolean {
    return this.#longer.isRunning(design);
  }

  /** Comparison of sizes and turns of the print; undefined before it begins. */
  printSizes(design: Design): PrintComparison | undefined {
    return this.#sizes.of(design);
  }

  /** Sizes of the print that are compared, as multiples of its own; undefined for the usual ones. */
  set offeredSizes(sizes: readonly number[] | undefined) {
    this.#sizes.offered = sizes;
  }

  /**
   * Follows a solved design until there is another request.
   * @param searches false for a design that is shown as it was given: no other answers are sought
   */
  follow(design: Design, result: SolveResult, searches = true): Promise<void> {
    return this.#take(design, result, [
      () => this.#comparison.follow(design, result),
      () => this.#remedies.follow(design, result),
      ...(searches ? [() => this.#search(design)] : []),
      () => this.#proving.follow(design, result),
    ]);
  }

  /** Searches longer, at the user's request. */
  async searchLonger(design: Design, result: SolveResult): Promise<void> {
    this.#longer.allow(design);
    await this.#take(design, result, [() => this.#longer.follow(design)]);
    if (this.#latest === design) await this.follow(design, result, false);
  }

  /** Compares sizes and turns of the print, at the user's request. */
  async comparePrintSizes(design: Design, result: SolveResult): Promise<void> {
    this.#sizes.allow(design);
    await this.#take(design, result, [() => this.#sizes.follow(design)]);
    if (this.#latest === design) await this.follow(design, result, false);
  }

  stop(): void {
    this.#latest = undefined;
    this.#comparison.stop();
    this.#remedies.stop();
    this.#proving.stop();
    this.#longer.stop();
    this.#sizes.stop();
  }

  /** Ends the comparison of sizes and turns; the answers so far stay. */
  endPrintSizes(design: Design): void {
    this.#sizes.end(design);
  }

  /** Ends the longer search; the answers so far stay. */
  endLongerSearch(design: Design): void {
    this.#longer.end(design);
  }

  /** Sizes come first: per solve, they make more seams match than seeds do. */
  async #search(design: Design): Promise<void> {
    if (!(await maySpend()) || this.#latest !== design) return;
    await this.#sizes.follow(design);
    if (this.#latest === design) await this.#longer.follow(design);
  }

  /** Takes steps for a solved design until there is another request. */
  async #take(design: Design, result: SolveResult, steps: readonly Step[]): Promise<void> {
    this.stop();
    this.#latest = design;
    this.#solver.learn(design, result);
    for (const step of steps) {
      await step();
      if (this.#latest !== design) return;
    }
  }
}
