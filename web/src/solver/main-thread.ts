import {loadingError} from './answers/broken.js';
import {unlessAborted} from './answers/unless-aborted.js';
import type {LocalAnswerer} from './answering.js';
import {modulesAt, type WorkerPlaces} from './page-worker.js';
import type {HooksOf} from './requests/kinds.js';
import type {Requests} from './requests/requests.js';
import {TextService} from './service.js';

/**
 * The solver on the page's own thread, in slices of a few milliseconds, for pages without a worker.
 * Steps that cannot be divided (meshing, one factorisation) still block the page, on a large
 * garment for some tenths of a second.
 */
export class MainThreadSolver extends TextService {
  readonly #wasmUrl: WorkerPlaces['wasmUrl'];
  #answerer: Promise<LocalAnswerer> | undefined;

  constructor({wasmUrl}: Pick<WorkerPlaces, 'wasmUrl'> = {}) {
    super();
    this.#wasmUrl = wasmUrl;
  }

  async ask<K extends keyof Requests>(
    kind: K,
    request: Requests[K]['request'],
    hooks: HooksOf<Requests[K]>,
  ): Promise<Requests[K]['answer']> {
    const answerer = await unlessAborted((this.#answerer ??= this.#load()), hooks.signal);
    return answerer.answer(kind, request, hooks);
  }

  /**
   * Loads the answerer only on demand. Few pages lack a worker, and the others need not fetch its
   * substitute.
   */
  async #load(): Promise<LocalAnswerer> {
    try {
      const {besideThePage, localAnswerer} = await import('./answering.js');
      const url = this.#wasmUrl;
      const at = url === undefined ? undefined : modulesAt(url);
      const sources = at
        ? {
            seamwise: () => at.seamwise,
            drape: () => at.drape,
            marker: () => at.marker,
            photo: () => at.photo,
          }
        : {};
      return localAnswerer({sources, pace: besideThePage});
    } catch (error) {
      this.#answerer = undefined; // the next request tries again
      throw loadingError(error, 'seamwise.wasm');
    }
  }
}
