/**
 * Searches for a better result of the same design until it is stopped. Each attempt searches twice
 * as long as the one before.
 */
import type {Design} from '../model/design/design.js';
import {problemOf} from '../model/documents/design-problem.js';
import type {SolveResult} from '../model/result/result.js';
import {finalMismatch} from '../scene/mismatch.js';
import type {SolverService} from '../solver/service.js';
import {NewestTask} from './background-task.js';
import {idle} from './idle.js';

/** State of an improvement. */
export interface Improving {
  readonly isRunning: boolean;
  /** Decrease of the mean mismatch since the first result. [cm] */
  readonly gained: number;
}

interface Answered {
  readonly design: Design;
  readonly result: SolveResult;
}

/** Greatest effort; more would take longer than users wait. */
export const mostEffort = 16;
/** Least mean gain that is visible. [cm] */
const leastGain = 0.005;

export class Improvement {
  readonly #solver: SolverService;
  readonly #changed: () => void;
  readonly #keep: (design: Design, effort: number, result: SolveResult) => Design;
  readonly #task = new NewestTask();
  /** State, with the design in its present form. */
  #state: (Improving & {readonly design: Design}) | undefined;

  /** @param keep receives every better result, and returns the design of that result */
  constructor(
    solver: SolverService,
    changed: () => void,
    keep: (design: Design, effort: number, result: SolveResult) => Design,
  ) {
    this.#solver = solver;
    this.#changed = changed;
    this.#keep = keep;
  }

  /** Undefined unless an improvement was requested. */
  of(design: Design): Improving | undefined {
    return this.#state?.design === design ? this.#state : undefined;
  }

  /**
   * Improves a result.
   * @param result the result of `design`
   * @returns the best result that was found
   */
  async start(design: Design, result: SolveResult): Promise<Answered> {
    this.stop();
    const {signal} = this.#task.begin();
    const first = finalMismatch(result).mean;
    let [best, mean]: [Answered, number] = [{design, result}, first];
    const tell = (isRunning: boolean): void => {
      this.#state = {isRunning, gained: first - mean, design: best.design};
      this.#changed();
    };
    tell(true);
    for (let effort = 2 * (design.options.effort ?? 1); effort <= mostEffort; effort *= 2) {
      await idle();
      const longer = {...design, options: {...design.options, effort}};
      // a failed solve or a stop ends the improvement; the gain so far is kept
      const next = await this.#solver.solve(problemOf(longer), {signal}).catch(() => undefined);
      if (!next || signal.aborted) break;
      const reached = finalMismatch(next).mean;
      if (mean - reached < leastGain) continue;
      mean = reached;
      best = {design: this.#keep(design, effort, next), result: next};
      tell(true);
    }
    if (!signal.aborted) this.stop();
    return best;
  }

  stop(): void {
    this.#task.stop();
    if (!this.#state?.isRunning) return;
    this.#state = {...this.#state, isRunning: false};
    this.#changed();
  }
}
