import {SolverError} from '../../model/failure.js';
import {internalError} from '../answers/broken.js';
import type {RequestKinds} from '../requests/kinds.js';
import type {FromThread, ToThread} from './protocol.js';
import type {StartThread, Thread} from './thread.js';

/** Who has a thread watched. */
export interface WatchOwner {
  receive(message: FromThread): void;
  /** How long the thread may be silent just now; null when nothing is expected of it. [ms] */
  patience(): number | null;
  /** The thread has been ended, perhaps because it kept silent. */
  lost(failure: SolverError, silent: boolean): void;
}

/** How a thread is started. */
export interface ThreadStart<R extends RequestKinds> {
  readonly start: StartThread<R>;
  /** How long it may take until it is first heard of. [ms] */
  readonly patience: number;
  /** Why there can be no such thread. @param reason empty where nothing is known */
  readonly failure: (reason: string) => SolverError;
}

/** Silence is counted in ticks, so that a page that was busy or asleep itself counts as one. [ms] */
const tick = 50;

/** The watch over a thread: it is ended when it breaks, or owes an answer for too long. */
export class WatchedThread<R extends RequestKinds> {
  readonly #thread: Thread<R>;
  readonly #owner: WatchOwner;
  readonly #places: ThreadStart<R>;
  /** Runs until the thread is first heard of, and while something is expected. */
  #clock: ReturnType<typeof setInterval> | undefined;
  #ready = false;
  /** For how long nothing has been heard. [ms] */
  #silence = 0;

  /** @throws {SolverError} if there can be no thread, as is known at once */
  constructor(places: ThreadStart<R>, owner: WatchOwner) {
    this.#owner = owner;
    this.#places = places;
    this.#thread = places.start({
      receive: (message) => {
        this.#ready = true;
        this.#silence = 0;
        owner.receive(message);
      },
      lost: (reason) => {
        this.#lose(this.#ready ? brokenBy(reason) : places.failure(reason));
      },
    });
    this.#expect();
  }

  /** @throws what cannot be copied or transferred */
  post(message: ToThread<R>, transfer?: readonly ArrayBuffer[]): void {
    this.#thread.post(message, transfer);
    this.#expect();
  }

  /** Counts from now on what has to be answered with less patience than before. */
  hurry(): void {
    this.#silence = 0;
  }

  end(): void {
    clearInterval(this.#clock);
    this.#thread.end();
  }

  #expect(): void {
    this.#clock ??= setInterval(() => {
      this.#watch();
    }, tick);
  }

  #watch(): void {
    const patience = this.#ready ? this.#owner.patience() : this.#places.patience;
    if (patience === null) {
      clearInterval(this.#clock);
      this.#clock = undefined;
      this.#silence = 0;
      return;
    }
    this.#silence += tick;
    if (this.#silence <= patience) {
      if (this.#ready) this.post({kind: 'ping'});
    } else if (this.#ready) {
      this.#lose(broken('The solver stopped answering; try again.'), true);
    } else {
      const reason = `nothing is heard of it for ${this.#silence / 1000} s`;
      this.#lose(this.#places.failure(reason));
    }
  }

  #lose(failure: SolverError, silent = false): void {
    this.end();
    this.#owner.lost(failure, silent);
  }
}

const brokenBy = (reason: string): SolverError =>
  reason === ''
    ? broken('The solver broke; try again.')
    : internalError('The solver broke', reason);

function broken(message: string): SolverError {
  return new SolverError({code: 'internal', message});
}
