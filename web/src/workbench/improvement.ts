/** A better answer to the same question, looked for as long as somebody lets it: each try looks twice as long as the one before. */
import type {Design} from '../model/design.js';
import {problemOf} from '../model/design-problem.js';
import type {SolveResult} from '../model/result.js';
import {finalMismatch} from '../scene/mismatch.js';
import type {SolverService} from '../solver/service.js';
import {NewestTask} from './background-task.js';
import {idle} from './idle.js';

/** How far it has come. */
export interface Improving {
  readonly isRunning: boolean;
  /** By how much seams meet better on average than in the answer that it began with. [cm] */
  readonly gained: number;
}

interface Answered {
  readonly design: Design;
  readonly result: SolveResult;
}

/** Beyond this nobody waits. */
export const mostEffort = 16;
/** What can be seen of a gain, on average. [cm] */
const leastGain = 0.005;

export class Improvement {
  readonly #solver: SolverService;
  readonly #changed: () => void;
  readonly #keep: (design: Design, effort: number, result: SolveResult) => Design;
  readonly #task = new NewestTask();
  /** Of which design, as it is now. */
  #state: (Improving & {readonly design: Design}) | undefined;

  /** @param keep is handed every better answer, and gives back the design that it answers from then on */
  constructor(
    solver: SolverService,
    changed: () => void,
    keep: (design: Design, effort: number, result: SolveResult) => Design,
  ) {
    this.#solver = solver;
    this.#changed = changed;
    this.#keep = keep;
  }

  /** Undefined where nobody has asked for it. */
  of(design: Design): Improving | undefined {
    return this.#state?.design === design ? this.#state : undefined;
  }

  /** @param result the answer to `design`. @returns the best that was found */
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
      // what cannot be solved any more, or is stopped, ends it: what was gained by then is kept
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
