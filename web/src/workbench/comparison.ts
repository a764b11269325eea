/** What the symmetries of a design cost: the same design solved without them, when nothing else is to be done. */
import type {Design} from '../model/design.js';
import {problemOf} from '../model/design-problem.js';
import type {SolveResult} from '../model/result.js';
import {countedSeams, finalMismatch} from '../scene/mismatch.js';
import type {SolverService} from '../solver/service.js';
import {DesignFindings, NewestTask} from './background-task.js';

export class Comparison {
  readonly #solver: SolverService;
  readonly #task = new NewestTask();
  readonly #means: DesignFindings<number>;
  /** The last design without symmetries, and what came of it. */
  #free: {readonly design: Design; readonly result: SolveResult} | undefined;

  constructor(solver: SolverService, changed: () => void) {
    this.#solver = solver;
    this.#means = new DesignFindings(changed);
  }

  /** The mean mismatch without symmetries, along the seams that count with them. [cm] */
  of(design: Design): number | undefined {
    return this.#means.of(design);
  }

  /** A design has been solved; if its answer has symmetries, it is solved without them as well. */
  async follow(design: Design, result: SolveResult): Promise<void> {
    this.stop();
    if (result.symmetries.length === 0) {
      this.#free = {design, result};
    } else if (this.#means.of(design) === undefined) {
      if (!this.#free || !differOnlyInSymmetry(this.#free.design, design)) {
        if (!(await this.#solveFree(design, this.#task.begin().signal))) return;
      }
      this.#compare(design, result);
    }
  }

  stop(): void {
    this.#task.stop();
  }

  /** @returns whether there is an answer */
  async #solveFree(design: Design, signal: AbortSignal): Promise<boolean> {
    const free: Design = {...design, symmetry: 'none'};
    // the main solve has said what there is to say; without a comparison none is shown
    const result = await this.#solver.solve(problemOf(free), {signal}).catch(() => undefined);
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
    this.#means.learn(design, mean);
  }
}

const differOnlyInSymmetry = (a: Design, b: Design): boolean =>
  a.garment === b.garment &&
  a.print === b.print &&
  a.method === b.method &&
  a.options === b.options &&
  a.seed === b.seed;
