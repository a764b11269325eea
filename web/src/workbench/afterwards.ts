/**
 * Work after a solve: cost of the symmetries, remedies, bound on the alignment, and on request a
 * better result.
 */
import type {Design} from '../model/design/design.js';
import type {SolveResult} from '../model/result/result.js';
import type {SeamCount} from '../model/result/seam-groups.js';
import type {Remedy} from '../remedies/remedy.js';
import type {SolverService} from '../solver/service.js';
import {Comparison, Improvement, Proving, RemedySearch, type Improving} from './improvement.js';
import {Observable} from './observable.js';
import {PrintSizes, type SizeComparison} from './print-sizes.js';

/**
 * Stores a better result of the present design, found with more effort.
 * @returns the design of that result, from now on the present one
 */
type Improved = (design: Design, effort: number, result: SolveResult) => Design;

export class Afterwards extends Observable {
  readonly #comparison: Comparison;
  readonly #remedies: RemedySearch;
  readonly #proving: Proving;
  readonly #improvement: Improvement;
  readonly #sizes: PrintSizes;
  #latest: Design | undefined;

  constructor(solver: SolverService, improved: Improved) {
    super();
    const changed = (): void => {
      this.changed();
    };
    this.#comparison = new Comparison(solver, changed);
    this.#remedies = new RemedySearch(solver, changed);
    this.#proving = new Proving(solver, changed);
    this.#sizes = new PrintSizes(solver, changed);
    this.#improvement = new Improvement(solver, changed, (design, effort, result) => {
      this.#latest = improved(design, effort, result);
      return this.#latest;
    });
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

  improving(design: Design): Improving | undefined {
    return this.#improvement.of(design);
  }

  /** Comparison of sizes of the print; undefined unless it was requested. */
  printSizes(design: Design): SizeComparison | undefined {
    return this.#sizes.of(design);
  }

  /** Follows a solved design until there is another request. */
  async follow(design: Design, result: SolveResult): Promise<void> {
    this.stop();
    this.#latest = design;
    await this.#comparison.follow(design, result);
    if (this.#latest === design) await this.#remedies.follow(design, result);
    if (this.#latest === design) await this.#proving.follow(design, result);
  }

  /**
   * Improves a result until it is stopped or there is another request.
   * @param result the result of `design`
   */
  async improve(design: Design, result: SolveResult): Promise<void> {
    this.stop();
    this.#latest = design;
    const best = await this.#improvement.start(design, result);
    if (this.#latest === best.design) await this.follow(best.design, best.result);
  }

  /**
   * Compares sizes of the print until it is stopped or there is another request.
   * @param result the result of `design`
   */
  async comparePrintSizes(design: Design, result: SolveResult): Promise<void> {
    this.stop();
    this.#latest = design;
    await this.#sizes.compare(design);
    if (this.#latest === design) await this.follow(design, result);
  }

  stop(): void {
    this.#latest = undefined;
    this.#comparison.stop();
    this.#remedies.stop();
    this.#proving.stop();
    this.#improvement.stop();
    this.#sizes.stop();
  }

  /** Stops the comparison of sizes; the answers so far stay. */
  stopPrintSizes(): void {
    this.#sizes.stop();
  }

  /** Stops the improvement; the gain so far stays. */
  stopImproving(): void {
    this.#improvement.stop();
  }
}
