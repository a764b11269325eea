/// <reference lib="esnext.disposable" preserve="true" />
import {pageWorker, type WorkerPlaces} from './page-worker.js';
import type {HooksOf} from './requests/kinds.js';
import type {Requests} from './requests/requests.js';
import {TextService} from './service.js';
import {ThreadClient} from './threads/thread-client.js';

export type {
  NamedPrepareHooks,
  NamedProofHooks,
  NamedSolveHooks,
  ProblemNames,
} from './requests/texts.js';
export type {GarmentHooks, QuestionHooks, SolverService, TextService} from './service.js';
export type {WorkerPlaces} from './page-worker.js';

/**
 * The solver in its own worker, for pages; it never keeps the page from drawing. The worker starts
 * with the first call; jobs share it. Arguments are copied, never transferred. A call never stays
 * pending: if the worker breaks, the call is rejected, and the next call starts another worker.
 */
export class SolverClient extends TextService implements Disposable {
  readonly #worker: ThreadClient<Requests>;
  readonly #helpers: () => number;

  /** @param helpers returns the number of threads that may help with a solve at present */
  constructor(places: WorkerPlaces = {}, helpers: () => number = () => 0) {
    super();
    this.#worker = new ThreadClient(pageWorker(places));
    this.#helpers = helpers;
  }

  /**
   * Answers a request.
   * @throws {SolverError} `worker-blocked`, before any hook is called, if no worker can be started
   */
  ask<K extends keyof Requests>(
    kind: K,
    request: Requests[K]['request'],
    hooks: HooksOf<Requests[K]>,
  ): Promise<Requests[K]['answer']> {
    return this.#worker.ask(kind, request, {...hooks, helpers: this.#helpers()});
  }

  /** Ends the worker. Pending requests and all later ones are rejected as cancelled. */
  dispose(): void {
    this.#worker.dispose();
  }

  [Symbol.dispose](): void {
    this.dispose();
  }
}
