/** Bound on the alignment of a design, computed in the background. */
import {provenShare} from '../model/base/core-tables.js';
import type {Design} from '../model/design/design.js';
import {problemOf} from '../model/documents/design-problem.js';
import type {Proof, SolveResult} from '../model/result/result.js';
import type {SolverService} from '../solver/service.js';
import {DesignFindings, NewestTask} from './background-task.js';
import {paused} from './idle.js';

/** Time limit of a proof. The rest would take far longer, and drain a battery. [ms] */
const patience = 60_000;

/** A share in whole per cent, since smaller changes are not reported; 101 for a complete proof. */
const percent = (share: number): number => (share === 1 ? 101 : Math.floor(100 * share));

export class Proving {
  readonly #solver: SolverService;
  readonly #task = new NewestTask();
  readonly #bounds: DesignFindings<number>;

  constructor(solver: SolverService, changed: () => void) {
    this.#solver = solver;
    this.#bounds = new DesignFindings(changed);
  }

  /**
   * Bound on the alignment: no other one has less than this share of the present one's mismatch.
   */
  of(design: Design): number | undefined {
    return this.#bounds.of(design);
  }

  /** Follows a solved design. */
  async follow(design: Design, {metrics}: SolveResult): Promise<void> {
    this.stop();
    const {method, searchBound, searchCost} = metrics;
    if (method !== 'best' || searchBound === 1 || this.#bounds.isFinished(design)) return;
    const running = this.#task.begin();
    await paused(running.signal);
    const late = setTimeout(() => {
      this.#bounds.finish(design); // a longer proof is not worth it
      running.abort();
    }, patience);
    const onProof = ({bound, searchCost: found}: Proof): void => {
      // the proof's alignment is another one after more effort, or if a cutter's layout or a
      // symmetric one is used
      const share = (bound * found) / searchCost;
      const known = share >= 1 - provenShare ? 1 : Math.max(share, searchBound);
      this.#bounds.learn(design, known, percent(known) > percent(this.of(design) ?? 0));
    };
    try {
      await this.#solver.prove(problemOf(design), {signal: running.signal, onProof});
      this.#bounds.finish(design);
    } catch {
      // the proof was not requested, so errors are ignored; the bound so far stays
    } finally {
      clearTimeout(late);
    }
  }

  stop(): void {
    this.#task.stop();
  }
}
