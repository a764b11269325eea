/// <reference lib="esnext.disposable" preserve="true" />
/** Solvers of a page: in a worker, and on the page's own thread if it cannot have one. */
import type {HooksOf, Requests} from './requests/requests.js';
import {TextService} from './service.js';
import {ThreadClient, type ThreadStart} from './threads/thread-client.js';
import {
  loadingError,
  reasonOf,
  unlessAborted,
  workerBlocked,
  workerNotTrusted,
} from './answers/failures.js';
import {trustedScript} from '../model/base/trusted.js';
import {workerThread} from './threads/thread.js';
import type {LocalAnswerer} from './answer-table.js';

/** URLs of the worker's script and the .wasm file, if they differ from those of the build. */
export interface WorkerPlaces {
  /** A module script that is equivalent to `solver.worker.js`, from the page's own origin. */
  readonly workerUrl?: string | URL;
  readonly wasmUrl?: string | URL;
  /** Time limit for fetching and starting the worker's script. Default 20 s. [ms] */
  readonly loadingPatience?: number;
}

/** Long enough for a script of a few kilobytes on a slow connection. [ms] */
const usualLoadingPatience = 20_000;

/** The script is beside this file when it is served as compiled. */
const usualScript = 'solver.worker.js';

/** URLs of the modules: the solver's, and beside it those of drape, marker and photo. */
export function modulesAt(wasmUrl: string | URL): {
  seamwise: string;
  drape: string;
  marker: string;
  photo: string;
} {
  const seamwise = new URL(wasmUrl, document.baseURI).href;
  const beside = (file: string) => new URL(file, seamwise).href;
  return {
    seamwise,
    drape: beside('drape.wasm'),
    marker: beside('marker.wasm'),
    photo: beside('photo.wasm'),
  };
}

/** A worker of the page. */
export function pageWorker(places: WorkerPlaces): ThreadStart<Requests> {
  const {workerUrl, wasmUrl, loadingPatience} = places;
  return {
    start: (owner) => {
      const thread = workerThread<Requests>(started(workerUrl), owner);
      if (wasmUrl !== undefined) {
        thread.post({kind: 'modules', sources: modulesAt(wasmUrl)});
      }
      return thread;
    },
    patience: loadingPatience ?? usualLoadingPatience,
    failure: (reason) => workerBlocked(workerUrl ?? usualScript, reasonOf(reason)),
  };
}

/** Starts the worker. @throws {SolverError} `worker-blocked` if the browser rejects it at once */
function started(workerUrl: string | URL | undefined): Worker {
  const script = workerUrl ?? usualScript;
  const make = (): Worker => {
    if (workerUrl !== undefined) return new Worker(workerUrl, {type: 'module'});
    // bundlers recognise exactly this expression
    return new Worker(new URL('./solver.worker.js', import.meta.url), {type: 'module'});
  };
  try {
    return make();
  } catch (refusal) {
    if (!mayWantTrust(refusal)) throw workerBlocked(script, reasonOf(refusal));
  }
  try {
    return madeWithTrust(make);
  } catch (refusal) {
    throw workerNotTrusted(script, reasonOf(refusal));
  }
}

/**
 * Returns whether a page with Trusted Types may have rejected a worker because its URL is not
 * trusted.
 */
const mayWantTrust = (refusal: unknown): boolean =>
  'trustedTypes' in globalThis && refusal instanceof TypeError;

/**
 * Makes `make` start its worker from a URL that the page trusts. Bundlers insert the URL only into
 * the expression that creates a worker from a URL. So `Worker` is replaced while `make` runs, and
 * takes the URL from there.
 * @throws {TypeError} if the page trusts no URL of this package
 */
function madeWithTrust(make: () => Worker): Worker {
  const {Worker: Plain} = globalThis;
  globalThis.Worker = class extends Plain {
    constructor(url: string | URL, options?: WorkerOptions) {
      super(trustedScript(String(url)), options);
    }
  };
  try {
    return make();
  } finally {
    globalThis.Worker = Plain;
  }
}

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
      const {besideThePage, localAnswerer} = await import('./answer-table.js');
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

export type {
  NamedPrepareHooks,
  NamedProofHooks,
  NamedSolveHooks,
  ProblemNames,
} from './requests/requests.js';
export type {GarmentHooks, QuestionHooks, SolverService, TextService} from './service.js';

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
