import {SolverError} from '../model/failure.js';
import {internalError} from './broken.js';
import type {FromWorker, ToWorker} from './protocol.js';

/** Where the worker's script and the .wasm file are, if not where the build has put them. */
export interface WorkerPlaces {
  /** A module script that does what `solver.worker.js` does; from the page's own origin. */
  readonly workerUrl?: string | URL;
  readonly wasmUrl?: string | URL;
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
const tick = 250;

/** A script that has to be fetched first may take this long. [ms] */
const loadingPatience = 60_000;

/** A worker, and the watch over it: it is ended when it breaks, or owes an answer for too long. */
export class WatchedWorker {
  readonly #worker: Worker;
  readonly #owner: WorkerOwner;
  readonly #listening = new AbortController();
  /** Runs while something is expected. */
  #clock: ReturnType<typeof setInterval> | undefined;
  #ready = false;
  /** For how long nothing has been heard. [ms] */
  #silence = 0;

  /** @throws whatever the browser says against such a worker */
  constructor(places: WorkerPlaces, owner: WorkerOwner) {
    this.#owner = owner;
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
      this.#lose(brokenBy(event, this.#ready));
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
    if (this.#silence > (this.#ready ? expected : loadingPatience)) {
      this.#lose(broken('The solver stopped answering; try again.'), true);
    } else {
      this.post({kind: 'ping'});
    }
  }

  #lose(failure: SolverError, silent = false): void {
    this.end();
    this.#owner.lost(failure, silent);
  }
}

function start(workerUrl: string | URL | undefined): Worker {
  if (workerUrl !== undefined) return new Worker(workerUrl, {type: 'module'});
  // Bundlers look for exactly this; served as compiled, the file is this one's neighbour.
  return new Worker(new URL('./solver.worker.js', import.meta.url), {type: 'module'});
}

function brokenBy(event: Event, ready: boolean): SolverError {
  if (event instanceof ErrorEvent && event.message) {
    return internalError('The solver broke', event.message);
  }
  if (ready) return broken('The solver broke; try again.');
  return broken('The solver could not be loaded; check the connection, then try again.');
}

function broken(message: string): SolverError {
  return new SolverError({code: 'internal', message});
}
