import {reasonOf, workerBlocked, workerNotTrusted} from './answers/broken.js';
import {trustedScript} from '../model/trusted.js';
import type {Requests} from './requests/requests.js';
import {workerThread} from './threads/thread.js';
import type {ThreadStart} from './threads/watched-thread.js';

/** Where the worker's script and the .wasm file are, if not where the build has put them. */
export interface WorkerPlaces {
  /** A module script that does what `solver.worker.js` does; from the page's own origin. */
  readonly workerUrl?: string | URL;
  readonly wasmUrl?: string | URL;
  /** How long the worker's script may take to be fetched and run: 20 s, unless said otherwise. [ms] */
  readonly loadingPatience?: number;
}

/** Long enough for a script of a few kilobytes on a bad line. [ms] */
const usualLoadingPatience = 20_000;

/** Served as compiled, the script is this file's neighbour. */
const usualScript = 'solver.worker.js';

/** Where the modules are: that of the solver, and beside it those that drape, lay pieces and read pictures. */
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

/** A worker of the page's. */
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

/** @throws {SolverError} `worker-blocked` if the browser says so at once */
function started(workerUrl: string | URL | undefined): Worker {
  const script = workerUrl ?? usualScript;
  const make = (): Worker => {
    if (workerUrl !== undefined) return new Worker(workerUrl, {type: 'module'});
    // Bundlers look for exactly this.
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

/** Whether a page whose policy demands Trusted Types may have refused a worker for want of trust. */
const mayWantTrust = (refusal: unknown): boolean =>
  'trustedTypes' in globalThis && refusal instanceof TypeError;

/**
 * Has `make` make its worker from an address that the page trusts. Bundlers put the address where they find a worker
 * made of a URL, and nowhere else: so it is taken from there, while `make` runs.
 * @throws {TypeError} where the page trusts no address of ours
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
