/** What the symmetries of a design cost: the same design solved without them, when nothing else is to be done. */
import type {Design} from '../../model/design.js';
import type {Problem} from '../../model/problem.js';
import type {Metrics} from '../../model/result.js';
import type {SolverService} from '../../solver/service.js';

export class Comparison {
  readonly #solver: SolverService;
  readonly #problemOf: (design: Design) => Problem;
  readonly #changed: () => void;
  readonly #known = new WeakMap<Design, Metrics>();
  /** The last design without symmetries, and what it reached. */
  #free: {readonly design: Design; readonly metrics: Metrics} | undefined;
  #running: AbortController | undefined;

  constructor(solver: SolverService, problemOf: (design: Design) => Problem, changed: () => void) {
    this.#solver = solver;
    this.#problemOf = problemOf;
    this.#changed = changed;
  }

  of(design: Design): Metrics | undefined {
    return this.#known.get(design);
  }

  /** A design has been solved; if it has symmetries, it is solved without them as well. */
  follow(design: Design, metrics: Metrics): void {
    this.stop();
    if (design.symmetries.length === 0) {
      this.#free = {design, metrics};
    } else if (!this.#known.has(design)) {
      if (this.#free && differOnlyInSymmetry(this.#free.design, design)) {
        this.#known.set(design, this.#free.metrics);
      } else {
        this.#running = new AbortController();
        void this.#run(design, this.#running.signal);
      }
    }
  }

  stop(): void {
    this.#running?.abort();
    this.#running = undefined;
  }

  async #run(design: Design, signal: AbortSignal): Promise<void> {
    const free = {...design, symmetries: []};
    try {
      const {metrics} = await this.#solver.solve(
        {...this.#problemOf(free), symmetry: 'none'},
        {signal},
      );
      this.#free = {design: free, metrics};
      this.#known.set(design, metrics);
      this.#changed();
    } catch {
      // the main solve has said what there is to say; without a comparison none is shown
    }
  }
}

const differOnlyInSymmetry = (a: Design, b: Design): boolean =>
  a.garment === b.garment &&
  a.print === b.print &&
  a.method === b.method &&
  a.options === b.options;
