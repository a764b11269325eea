/** Searches for changes that make the mismatched seams of a design match, in the background. */
import type {Design} from '../model/design/design.js';
import {problemOf} from '../model/documents/design-problem.js';
import type {SolveResult} from '../model/result/result.js';
import type {Remedy} from '../remedies/remedy.js';
import type {SolverService} from '../solver/service.js';
import {DesignFindings, NewestTask} from './background-task.js';
import {idle, paused} from './idle.js';

export class RemedySearch {
  readonly #solver: SolverService;
  readonly #task = new NewestTask();
  readonly #remedies: DesignFindings<readonly Remedy[]>;

  constructor(solver: SolverService, changed: () => void) {
    this.#solver = solver;
    this.#remedies = new DesignFindings(changed);
  }

  /** Remedies found so far. */
  of(design: Design): readonly Remedy[] {
    return this.#remedies.of(design) ?? [];
  }

  /** Follows a solved design. */
  async follow(design: Design, result: SolveResult): Promise<void> {
    this.stop();
    if (this.#remedies.isFinished(design)) return;
    const {signal} = this.#task.begin();
    const found: Remedy[] = [];
    try {
      await paused(signal);
      signal.throwIfAborted();
      const {remediesOf} = await import('../remedies/remedies.js');
      signal.throwIfAborted();
      await remediesOf(
        problemOf(design),
        result,
        (problem, stop) => this.#solver.solve(problem, stop ? {signal: stop} : {}),
        {
          signal,
          idle,
          onRemedy: (remedy) => {
            found.push(remedy);
            this.#remedies.learn(design, [...found]);
          },
        },
      );
      this.#remedies.finish(design);
    } catch {
      // the user has gone on; the search is repeated when they return to the design
    }
  }

  stop(): void {
    this.#task.stop();
  }
}
