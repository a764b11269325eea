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
 * The solver in a worker of its own, for pages: nothing here keeps the page from drawing. The worker
 * starts with the first call; jobs share it. What a caller hands over is copied, never taken away.
 * A call never stays pending: if the worker breaks, it is rejected, and the next call starts another.
 */
export class SolverClient extends TextService implements Disposable {
  readonly #worker: ThreadClient<Requests>;
  readonly #helpers: () => number;

  /** @param helpers how many threads may help with a solve just now */
  constructor(places: WorkerPlaces = {}, helpers: () => number = () => 0) {
    super();
    this.#worker = new ThreadClient(pageWorker(places));
    this.#helpers = helpers;
  }

  /** @throws {SolverError} `worker-blocked`, before anything else is heard, if there can be no worker */
  ask<K extends keyof Requests>(
    kind: K,
    request: Requests[K]['request'],
    hooks: HooksOf<Requests[K]>,
  ): Promise<Requests[K]['answer']> {
    return this.#worker.ask(kind, request, {...hooks, helpers: this.#helpers()});
  }

  /** Ends the worker; what is pending, and what is asked from now on, is rejected as cancelled. */
  dispose(): void {
    this.#worker.dispose();
  }

  [Symbol.dispose](): void {
    this.dispose();
  }
}
