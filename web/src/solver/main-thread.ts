import {loadingError} from './broken.js';
import type {LocalSolver} from './local.js';
import type {Answers, QuestionOf} from './protocol.js';
import {besideThePage} from './pace.js';
import {TextService, type QuestionHooks} from './service.js';
import {unlessAborted} from './unless-aborted.js';
import type {WorkerPlaces} from './watched-worker.js';

/**
 * The solver on the page's own thread, in slices of a few milliseconds: for pages that may have no
 * worker. What cannot be cut (meshing, one factorisation) still holds up the page, on a large garment for
 * some tenths of a second.
 */
export class MainThreadSolver extends TextService {
  readonly #wasmUrl: WorkerPlaces['wasmUrl'];
  #solver: Promise<LocalSolver> | undefined;

  constructor({wasmUrl}: Pick<WorkerPlaces, 'wasmUrl'> = {}) {
    super();
    this.#wasmUrl = wasmUrl;
  }

  async ask<K extends keyof Answers>(
    question: QuestionOf<K>,
    hooks: QuestionHooks,
  ): Promise<Answers[K]> {
    const solver = await unlessAborted((this.#solver ??= this.#load()), hooks.signal);
    return solver.answer<K>(question, hooks);
  }

  /** Few pages have no worker: the others need not fetch what would take its place. */
  async #load(): Promise<LocalSolver> {
    try {
      const {LocalSolver} = await import('./local.js');
      const url = this.#wasmUrl;
      const settings = () =>
        url === undefined ? {} : {locateFile: () => new URL(url, document.baseURI).href};
      return new LocalSolver(settings, {pace: besideThePage});
    } catch (error) {
      this.#solver = undefined; // to be tried again
      throw loadingError(error);
    }
  }
}
