/** What is worked on once an answer is there: what its symmetries cost, what would help it, how good it can be, and a better one when asked. */
import type {Design} from '../model/design.js';
import type {Problem} from '../model/problem.js';
import type {SolveResult} from '../model/result.js';
import type {Remedy} from '../remedies/remedy.js';
import type {SolverService} from '../solver/service.js';
import {Comparison} from './comparison.js';
import {Improvement, type Improving} from './improvement.js';
import {Proving} from './proving.js';
import {RemedySearch} from './remedy-search.js';

interface AfterwardsHooks {
  /** What the solver is asked for a design. */
  readonly problemOf: (design: Design) => Problem;
  readonly changed: () => void;
  /** A better answer to the present design, looked for with more effort. @returns the design that it answers, from now the present one */
  readonly improved: (design: Design, effort: number, result: SolveResult) => Design;
}

export class Afterwards {
  readonly #comparison: Comparison;
  readonly #remedies: RemedySearch;
  readonly #proving: Proving;
  readonly #improvement: Improvement;
  #latest: Design | undefined;

  constructor(solver: SolverService, {problemOf, changed, improved}: AfterwardsHooks) {
    this.#comparison = new Comparison(solver, problemOf, changed);
    this.#remedies = new RemedySearch(solver, problemOf, changed);
    this.#proving = new Proving(solver, problemOf, changed);
    this.#improvement = new Improvement(solver, problemOf, changed, (design, effort, result) => {
      this.#latest = improved(design, effort, result);
      return this.#latest;
    });
  }

  /** The mean mismatch without symmetries, along the seams that count with them. [cm] */
  withoutSymmetry(design: Design): number | undefined {
    return this.#comparison.of(design);
  }

  remedies(design: Design): readonly Remedy[] {
    return this.#remedies.of(design);
  }

  /** No other placing misses by less than this share of what the present one misses by. */
  bound(design: Design): number | undefined {
    return this.#proving.of(design);
  }

  improving(design: Design): Improving | undefined {
    return this.#improvement.of(design);
  }

  /** A design has been solved, and nobody has asked for anything since. */
  async follow(design: Design, result: SolveResult): Promise<void> {
    this.stop();
    this.#latest = design;
    await this.#comparison.follow(design, result);
    if (this.#latest === design) await this.#remedies.follow(design, result);
    if (this.#latest === design) await this.#proving.follow(design, result);
  }

  /** Until somebody stops it, or does anything else. @param result the answer to `design` */
  async improve(design: Design, result: SolveResult): Promise<void> {
    this.stop();
    this.#latest = design;
    const best = await this.#improvement.start(design, result);
    if (this.#latest === best.design) await this.follow(best.design, best.result);
  }

  stop(): void {
    this.#latest = undefined;
    this.#comparison.stop();
    this.#remedies.stop();
    this.#proving.stop();
    this.#improvement.stop();
  }

  /** What was gained by then stays. */
  stopImproving(): void {
    this.#improvement.stop();
  }
}
