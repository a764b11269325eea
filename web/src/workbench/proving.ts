/** How good the placing of a design can be: looked into when nothing else is to be done. */
import {provenShare} from '../model/core-tables.js';
import type {Design} from '../model/design.js';
import {problemOf} from '../model/design-problem.js';
import type {Proof, SolveResult} from '../model/result.js';
import type {SolverService} from '../solver/service.js';
import {idle} from './idle.js';

/** What is not proven by then would need far longer, and a battery. [ms] */
const patience = 60_000;

export class Proving {
  readonly #solver: SolverService;
  readonly #changed: () => void;
  readonly #known = new WeakMap<Design, number>();
  /** Those that have been looked into for as long as makes sense. */
  readonly #done = new WeakSet<Design>();
  #running: AbortController | undefined;

  constructor(solver: SolverService, changed: () => void) {
    this.#solver = solver;
    this.#changed = changed;
  }

  /** No other placing misses by less than this share of what the present one misses by. */
  of(design: Design): number | undefined {
    return this.#known.get(design);
  }

  /** A design has been solved. */
  async follow(design: Design, {metrics}: SolveResult): Promise<void> {
    this.stop();
    const {method, searchBound, searchCost} = metrics;
    if (method !== 'best' || searchBound === 1 || this.#done.has(design)) return;
    const running = (this.#running = new AbortController());
    await idle();
    const {signal} = running;
    const late = setTimeout(() => {
      this.#done.add(design);
      running.abort();
    }, patience);
    const onProof = ({bound, searchCost: found}: Proof): void => {
      // after more effort, and where a cutter's layout or a symmetric placing stands, it is another one
      const share = (bound * found) / searchCost;
      this.#learn(design, share >= 1 - provenShare ? 1 : Math.max(share, searchBound));
    };
    try {
      await this.#solver.prove(problemOf(design), {signal, onProof});
      this.#done.add(design);
    } catch {
      // nobody has asked for it: what is known by then stays
    } finally {
      clearTimeout(late);
    }
  }

  stop(): void {
    this.#running?.abort();
    this.#running = undefined;
  }

  /** Only what can be told apart in whole per cent is news. */
  #learn(design: Design, bound: number): void {
    const percent = (share: number): number => (share === 1 ? 101 : Math.floor(100 * share));
    const isNews = percent(bound) > percent(this.#known.get(design) ?? 0);
    this.#known.set(design, bound);
    if (isNews) this.#changed();
  }
}
