import {SolverError} from '../model/failure.js';
import {internalError, reasonOf, workerBlocked, workerNotTrusted} from './broken.js';
import type {FromWorker, ToWorker} from './protocol.js';
import {madeWithTrust, mayWantTrust} from './trusted-worker.js';

/** Where the worker's script and the .wasm file are, if not where the build has put them. */
export interface WorkerPlaces {
  /** A module script that does what `solver.worker.js` does; from the page's own origin. */
  readonly workerUrl?: string | URL;
  readonly wasmUrl?: string | URL;
  /** How long the worker's script may take to be fetched and run: 20 s, unless said otherwise. [ms] */
  readonly loadingPatience?: number;
}

/** What a worker's owner hears of it. */
export interface WorkerOwner {
  receive(message: FromWorker): void;
  /** How long the worker may be silent just now; null when nothing is expected of it. [ms] */
  patience(): number | null;
  /** The worker has been ended, perhaps because it kept silent. */
  lost(failure: SolverError, silent: boolean): void;
}

/** Silence is counted in ticks, so that a page that was busy or asleep itself counts as one. [ms] */
const tick = 50;

/** Long enough for a script of a few kilobytes on a bad line. [ms] */
const usualLoadingPatience = 20_000;

/** Served as compiled, the script is this file's neighbour. */
const usualScript = 'solver.worker.js';

/** A worker, and the watch over it: it is ended when it breaks, or owes an answer for too long. */
export class WatchedWorker {
  readonly #worker: Worker;
  readonly #owner: WorkerOwner;
  readonly #script: string | URL;
  readonly #loadingPatience: number;
  readonly #listening = new AbortController();
  /** Runs while something is expected. */
  #clock: ReturnType<typeof setInterval> | undefined;
  #ready = false;
  /** For how long nothing has been heard. [ms] */
  #silence = 0;

  /** @throws {SolverError} `worker-blocked` if the browser says so at once */
  constructor(places: WorkerPlaces, owner: WorkerOwner) {
    this.#owner = owner;
    this.#script = places.workerUrl ?? usualScript;
    this.#loadingPatience = places.loadingPatience ?? usualLoadingPatience;
    this.#worker = start(places.workerUrl);
    this.#listen();
    if (places.wasmUrl !== undefined) {
      const wasmUrl = new URL(places.wasmUrl, document.baseURI).href;
      this.post({kind: 'locate', wasmUrl});
    }
  }

  post(message: ToWorker): void {
    this.#worker.postMessage(message);
    this.#clock ??= setInterval(() => {
      this.#watch();
    }, tick);
  }

  /** Counts from now on what has to be answered with less patience than before. */
  hurry(): void {
    this.#silence = 0;
  }

  end(): void {
    clearInterval(this.#clock);
    this.#listening.abort(); // what is still under way belongs to jobs of the past
    this.#worker.terminate();
  }

  #listen(): void {
    const {signal} = this.#listening;
    const receive = ({data}: MessageEvent<FromWorker>) => {
      this.#ready = true;
      this.#silence = 0;
      this.#owner.receive(data);
    };
    const fail = (event: Event) => {
      event.preventDefault(); // it need not be reported as the page's own as well
      this.#lose(this.#brokenBy(event));
    };
    this.#worker.addEventListener('message', receive, {signal});
    this.#worker.addEventListener('error', fail, {signal});
    this.#worker.addEventListener('messageerror', fail, {signal});
  }

  #watch(): void {
    const expected = this.#owner.patience();
    if (expected === null) {
      clearInterval(this.#clock);
      this.#clock = undefined;
      this.#silence = 0;
      return;
    }
    this.#silence += tick;
    if (!this.#ready && this.#silence > this.#loadingPatience) {
      this.#lose(
        workerBlocked(this.#script, `nothing is heard of it for ${this.#silence / 1000} s`),
      );
    } else if (this.#ready && this.#silence > expected) {
      this.#lose(broken('The solver stopped answering; try again.'), true);
    } else {
      this.post({kind: 'ping'});
    }
  }

  #lose(failure: SolverError, silent = false): void {
    this.end();
    this.#owner.lost(failure, silent);
  }

  #brokenBy(event: Event): SolverError {
    const reason = event instanceof ErrorEvent ? event.message : '';
    if (!this.#ready) return workerBlocked(this.#script, reasonOf(reason));
    return reason === ''
      ? broken('The solver broke; try again.')
      : internalError('The solver broke', reason);
  }
}

function start(workerUrl: string | URL | undefined): Worker {
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

function broken(message: string): SolverError {
  return new SolverError({code: 'internal', message});
}
