/** What the symmetries of a design cost: the same design solved without them, when nothing else is to be done. */
import type {Design} from '../model/design.js';
import type {Problem} from '../model/problem.js';
import type {SolveResult} from '../model/result.js';
import {countedSeams, finalMismatch} from '../scene/mismatch.js';
import type {SolverService} from '../solver/service.js';

export class Comparison {
  readonly #solver: SolverService;
  readonly #problemOf: (design: Design) => Problem;
  readonly #changed: () => void;
  readonly #known = new WeakMap<Design, number>();
  /** The last design without symmetries, and what came of it. */
  #free: {readonly design: Design; readonly result: SolveResult} | undefined;
  #running: AbortController | undefined;

  constructor(solver: SolverService, problemOf: (design: Design) => Problem, changed: () => void) {
    this.#solver = solver;
    this.#problemOf = problemOf;
    this.#changed = changed;
  }

  /** The mean mismatch without symmetries, along the seams that count with them. [cm] */
  of(design: Design): number | undefined {
    return this.#known.get(design);
  }

  /** A design has been solved; if it has symmetries, it is solved without them as well. */
  async follow(design: Design, result: SolveResult): Promise<void> {
    this.stop();
    if (design.symmetries.length === 0) {
      this.#free = {design, result};
    } else if (!this.#known.has(design)) {
      if (!this.#free || !differOnlyInSymmetry(this.#free.design, design)) {
        this.#running = new AbortController();
        if (!(await this.#solveFree(design, this.#running.signal))) return;
      }
      this.#compare(design, result);
    }
  }

  stop(): void {
    this.#running?.abort();
    this.#running = undefined;
  }

  /** @returns whether there is an answer */
  async #solveFree(design: Design, signal: AbortSignal): Promise<boolean> {
    const free = {...design, symmetries: []};
    const problem: Problem = {...this.#problemOf(free), symmetry: 'none'};
    // the main solve has said what there is to say; without a comparison none is shown
    const result = await this.#solver.solve(problem, {signal}).catch(() => undefined);
    if (result) this.#free = {design: free, result};
    return result !== undefined;
  }

  #compare(design: Design, result: SolveResult): void {
    if (!this.#free) return;
    const counted = countedSeams(result);
    // both are searches; without symmetry one is free to keep it
    const mean = Math.min(
      ...[this.#free.result, result].map((one) => finalMismatch(one, counted).mean),
    );
    this.#known.set(design, mean);
    this.#changed();
  }
}

const differOnlyInSymmetry = (a: Design, b: Design): boolean =>
  a.garment === b.garment &&
  a.print === b.print &&
  a.method === b.method &&
  a.options === b.options;
