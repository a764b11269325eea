/** What would make the seams of a design meet that stay off, looked for when nothing else is to be done. */
import type {Design} from '../model/design.js';
import {problemOf} from '../model/design-problem.js';
import type {SolveResult} from '../model/result.js';
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

  /** Those that are known by now. */
  of(design: Design): readonly Remedy[] {
    return this.#remedies.of(design) ?? [];
  }

  /** A design has been solved. */
  async follow(design: Design, result: SolveResult): Promise<void> {
    this.stop();
    if (this.#remedies.isFinished(design)) return;
    const {signal} = this.#task.begin();
    const found: Remedy[] = [];
    try {
      await paused();
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
      // somebody has gone on; when they come back it is looked for again
    }
  }

  stop(): void {
    this.#task.stop();
  }
}
