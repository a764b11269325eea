/** A search among variants of a solved design, in idle time. */
import type {Design} from '../model/design/design.js';
import type {PrintVariant} from '../model/print/print-variant.js';
import {together, type Standing} from '../model/result/visible-seams.js';
import type {AskedSearch} from '../solver/search/asked-search.js';
import {NewestTask} from './background-task.js';
import {paused} from './idle.js';
import type {IdleSolver} from './idle-solver.js';

/** Variants to compare, and the design of each. */
export interface VariantSearch extends Pick<AskedSearch, 'seed' | 'scales' | 'turns' | 'isLong'> {
  readonly designOf: (variant: PrintVariant, seed: number) => Design;
  /** Other garments on the same fabric, whose seams count, too. */
  readonly besideOf?: (variant: PrintVariant) => readonly Design[];
}

export abstract class IdleSearch {
  protected readonly solver: IdleSolver;
  readonly #changed: () => void;
  readonly #task = new NewestTask();
  readonly #finished = new WeakSet<Design>();
  #running: Design | undefined;

  /** @param changed called for every new answer, and when a search begins or ends */
  constructor(solver: IdleSolver, changed: () => void) {
    this.solver = solver;
    this.#changed = changed;
  }

  isRunning(design: Design): boolean {
    return this.#running === design;
  }

  /** Returns whether the search of a design is complete, or was ended by the user. */
  isFinished(design: Design): boolean {
    return this.#finished.has(design);
  }

  /** The searches of a design, one after the other; the answer of the design is known. */
  protected abstract searches(design: Design): readonly VariantSearch[];

  /** Searches until all is compared or there is another request. Answers by then stay. */
  async follow(design: Design): Promise<void> {
    this.stop();
    const searches = this.isFinished(design) ? [] : this.searches(design);
    if (searches.length === 0) return;
    const {signal} = this.#task.begin();
    const begun = (): void => {
      this.#run(design);
    };
    try {
      await paused(signal);
      const {bestAnswer} = await import('../solver/search/best-answer.js');
      for (const {designOf, besideOf, ...search} of searches) {
        await bestAnswer(
          {
            search,
            solve: async (variant, seed) => {
              signal.throwIfAborted();
              const standings: Standing[] = [];
              for (const one of [designOf(variant, seed), ...(besideOf?.(variant) ?? [])]) {
                standings.push(await this.solver.standing(one, signal, begun));
              }
              if (this.isRunning(design)) this.#changed();
              return together(standings);
            },
            standingOf: (standing) => standing,
          },
          {signal},
        );
      }
      this.#finished.add(design);
    } catch {
      // stopped, or the solver broke, which the next solve of the user reports
    }
    if (!signal.aborted) this.#run(undefined);
  }

  /** Ends the search of a design at the user's request; it does not begin again by itself. */
  end(design: Design): void {
    this.#finished.add(design);
    this.stop();
  }

  /** Lets a search begin again that the user has ended. */
  allow(design: Design): void {
    this.#finished.delete(design);
  }

  stop(): void {
    this.#task.stop();
    this.#run(undefined);
  }

  #run(design: Design | undefined): void {
    if (design === this.#running) return;
    this.#running = design;
    this.#changed();
  }
}
