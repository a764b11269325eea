/** How good the placing of a design can be: looked into when nothing else is to be done. */
import {provenShare} from '../model/core-tables.js';
import type {Design} from '../model/design.js';
import {problemOf} from '../model/design-problem.js';
import type {Proof, SolveResult} from '../model/result.js';
import type {SolverService} from '../solver/service.js';
import {DesignFindings, NewestTask} from './background-task.js';
import {paused} from './idle.js';

/** What is not proven by then would need far longer, and a battery. [ms] */
const patience = 60_000;

/** Only what can be told apart in whole per cent is news. */
const percent = (share: number): number => (share === 1 ? 101 : Math.floor(100 * share));

export class Proving {
  readonly #solver: SolverService;
  readonly #task = new NewestTask();
  readonly #bounds: DesignFindings<number>;

  constructor(solver: SolverService, changed: () => void) {
    this.#solver = solver;
    this.#bounds = new DesignFindings(changed);
  }

  /** No other placing misses by less than this share of what the present one misses by. */
  of(design: Design): number | undefined {
    return this.#bounds.of(design);
  }

  /** A design has been solved. */
  async follow(design: Design, {metrics}: SolveResult): Promise<void> {
    this.stop();
    const {method, searchBound, searchCost} = metrics;
    if (method !== 'best' || searchBound === 1 || this.#bounds.isFinished(design)) return;
    const running = this.#task.begin();
    await paused();
    const late = setTimeout(() => {
      this.#bounds.finish(design); // looked into for as long as makes sense
      running.abort();
    }, patience);
    const onProof = ({bound, searchCost: found}: Proof): void => {
      // after more effort, and where a cutter's layout or a symmetric placing stands, it is another one
      const share = (bound * found) / searchCost;
      const known = share >= 1 - provenShare ? 1 : Math.max(share, searchBound);
      this.#bounds.learn(design, known, percent(known) > percent(this.of(design) ?? 0));
    };
    try {
      await this.#solver.prove(problemOf(design), {signal: running.signal, onProof});
      this.#bounds.finish(design);
    } catch {
      // nobody has asked for it: what is known by then stays
    } finally {
      clearTimeout(late);
    }
  }

  stop(): void {
    this.#task.stop();
  }
}
