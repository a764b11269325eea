/**
 * A solver that outlives its lease: it takes one for each request, and may release it in between.
 */
import {leaseSolver, type LeasePlaces, type SolverLease} from '../../solver/pool.js';
import type {HooksOf} from '../../solver/requests/kinds.js';
import type {Requests} from '../../solver/requests/requests.js';
import {TextService} from '../../solver/service.js';

export class LastingSolver extends TextService implements SolverLease {
  readonly solver = this;
  readonly #places: () => LeasePlaces;
  #lease: SolverLease | undefined;

  /** @param places called for each new lease */
  constructor(places: () => LeasePlaces) {
    super();
    this.#places = places;
  }

  get #leased(): SolverLease {
    return (this.#lease ??= leaseSolver(this.#places()));
  }

  warm(): void {
    this.#leased.warm();
  }

  release(): void {
    this.#lease?.release();
    this.#lease = undefined;
  }

  ask<K extends keyof Requests>(
    kind: K,
    request: Requests[K]['request'],
    hooks: HooksOf<Requests[K]>,
  ): Promise<Requests[K]['answer']> {
    return this.#leased.solver.ask(kind, request, hooks);
  }
}
