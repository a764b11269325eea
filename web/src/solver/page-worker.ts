import {reasonOf, workerBlocked, workerNotTrusted} from './answers/broken.js';
import {trustedScript} from '../model/base/trusted.js';
import type {Requests} from './requests/requests.js';
import {workerThread} from './threads/thread.js';
import type {ThreadStart} from './threads/watched-thread.js';

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
