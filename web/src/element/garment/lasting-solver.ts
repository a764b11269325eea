/** A solver that outlives its lease: it takes one when it is asked, and can do without in between. */
import {leaseSolver, type LeasePlaces, type SolverLease} from '../../solver/pool.js';
import type {SolverService} from '../../solver/service.js';

export class LastingSolver implements SolverService, SolverLease {
  readonly solver = this;
  readonly #places: () => LeasePlaces;
  #lease: SolverLease | undefined;

  /** @param places asked for with every new lease */
  constructor(places: () => LeasePlaces) {
    this.#places = places;
  }

  get #solver(): SolverService {
    this.#lease ??= leaseSolver(this.#places());
    return this.#lease.solver;
  }

  warm(): void {
    this.#lease ??= leaseSolver(this.#places());
    this.#lease.warm();
  }

  release(): void {
    this.#lease?.release();
    this.#lease = undefined;
  }

  readonly solve: SolverService['solve'] = async (...asked) => this.#solver.solve(...asked);
  readonly prepare: SolverService['prepare'] = async (...asked) => this.#solver.prepare(...asked);
  readonly prove: SolverService['prove'] = async (...asked) => this.#solver.prove(...asked);
  readonly mirror: SolverService['mirror'] = async (...asked) => this.#solver.mirror(...asked);
  readonly garment: SolverService['garment'] = async (...asked) => this.#solver.garment(...asked);
  readonly convert: SolverService['convert'] = async (...asked) => this.#solver.convert(...asked);
  readonly symmetries: SolverService['symmetries'] = async (...asked) =>
    this.#solver.symmetries(...asked);
}
