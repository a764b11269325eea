/** Cost of a design's symmetries: solves the same design without them, in the background. */
import type {Design} from '../model/design/design.js';
import {problemOf} from '../model/documents/design-problem.js';
import type {SolveResult} from '../model/result/result.js';
import {countedSeams, finalMismatch} from '../scene/mismatch.js';
import type {SolverService} from '../solver/service.js';
import {DesignFindings, NewestTask} from './background-task.js';

export class Comparison {
  readonly #solver: SolverService;
  readonly #task = new NewestTask();
  readonly #means: DesignFindings<number>;
  /** The last design without symmetries, and its result. */
  #free: {readonly design: Design; readonly result: SolveResult} | undefined;

  constructor(solver: SolverService, changed: () => void) {
    this.#solver = solver;
    this.#means = new DesignFindings(changed);
  }

  /** Mean mismatch without symmetries, along the seams that count with them. [cm] */
  of(design: Design): number | undefined {
    return this.#means.of(design);
  }

  /** Follows a solved design. If its result has symmetries, it is also solved without them. */
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

  /** Solves a design without symmetries. @returns whether there is a result */
  async #solveFree(design: Design, signal: AbortSignal): Promise<boolean> {
    const free: Design = {...design, symmetry: 'none'};
    // a failure is not reported, since the main solve reports its own; no comparison is shown then
    const result = await this.#solver.solve(problemOf(free), {signal}).catch(() => undefined);
    if (result) this.#free = {design: free, result};
    return result !== undefined;
  }

  #compare(design: Design, result: SolveResult): void {
    if (!this.#free) return;
    const counted = countedSeams(result);
    // both are searches, and a solve without symmetries is free to keep the symmetric result
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
