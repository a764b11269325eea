/**
 * Work after a solve, in idle time: cost of the symmetries, remedies, searches for better answers,
 * and a bound on the alignment.
 */
import type {Design} from '../model/design/design.js';
import type {SolveResult} from '../model/result/result.js';
import type {SeamCount} from '../model/result/seam-groups.js';
import type {Remedy} from '../remedies/remedy.js';
import type {SolverService} from '../solver/service.js';
import {Comparison, Proving, RemedySearch} from './findings.js';
import {Observable} from './observable.js';
import {Searches, type SearchKind} from './searches.js';

type Step = () => Promise<void>;

export class Afterwards extends Observable {
  /** Observed separately, since it changes with each of many solves. */
  readonly searches: Searches;
  readonly #comparison: Comparison;
  readonly #remedies: RemedySearch;
  readonly #proving: Proving;
  #latest: Design | undefined;

  /** @param keep stores a result that may be offered, so that it is shown without a solve */
  constructor(solver: SolverService, keep: (design: Design, result: SolveResult) => void) {
    super();
    const changed = (): void => {
      this.changed();
    };
    this.searches = new Searches(solver, keep);
    this.#comparison = new Comparison(solver, changed);
    this.#remedies = new RemedySearch(solver, changed);
    this.#proving = new Proving(solver, changed);
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

  /**
   * Follows a solved design until there is another request.
   * @param searches false for a design that is shown as it was given: no other answers are sought
   */
  follow(design: Design, result: SolveResult, searches: boolean): Promise<void> {
    return this.#take(design, [
      () => this.#comparison.follow(design, result),
      () => this.#remedies.follow(design, result),
      ...(searches ? [() => this.searches.follow(design, result)] : []),
      () => this.#proving.follow(design, result),
    ]);
  }

  /** Searches for better answers at the user's request, then follows the design. */
  async search(kind: SearchKind, design: Design, result: SolveResult): Promise<void> {
    await this.#take(design, [() => this.searches.request(kind, design, result)]);
    if (this.#latest === design) await this.follow(design, result, false);
  }

  stop(): void {
    this.#latest = undefined;
    this.#comparison.stop();
    this.#remedies.stop();
    this.searches.stop();
    this.#proving.stop();
  }

  /** Takes steps for a solved design until there is another request. */
  async #take(design: Design, steps: readonly Step[]): Promise<void> {
    this.stop();
    this.#latest = design;
    for (const step of steps) {
      await step();
      if (this.#latest !== design) return;
    }
  }
}
