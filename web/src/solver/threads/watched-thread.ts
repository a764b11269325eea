import {SolverError} from '../../model/result/failure.js';
import {internalError} from '../answers/broken.js';
import type {RequestKinds} from '../requests/kinds.js';
import type {FromThread, ToThread} from './protocol.js';
import type {StartThread, Thread} from './thread.js';

/** Owner of a watched thread. */
export interface WatchOwner {
  receive(message: FromThread): void;
  /** Present time limit for the thread's silence; null when no message is expected. [ms] */
  patience(): number | null;
  /** Called when the thread has been ended. @param silent true if it exceeded the time limit */
  lost(failure: SolverError, silent: boolean): void;
}

/** Start of a thread, with its time limit and failure. */
export interface ThreadStart<R extends RequestKinds> {
  readonly start: StartThread<R>;
  /** Time limit for the first message. [ms] */
  readonly patience: number;
  /** Failure for a thread that cannot be started. @param reason empty if unknown */
  readonly failure: (reason: string) => SolverError;
}

/**
 * Silence is counted in ticks, so that a period in which the page itself was busy or asleep counts
 * as one tick. [ms]
 */
const tick = 50;

/** Watches a thread, and ends it when it breaks or when an expected message takes too long. */
export class WatchedThread<R extends RequestKinds> {
  readonly #thread: Thread<R>;
  readonly #owner: WatchOwner;
  readonly #places: ThreadStart<R>;
  /** Runs until the first message, and while a message is expected. */
  #clock: ReturnType<typeof setInterval> | undefined;
  #ready = false;
  /** Time since the last message. [ms] */
  #silence = 0;

  /** @throws {SolverError} if it is known at once that no thread can be started */
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

  /** Sends a message. @throws an error for a message that cannot be copied or transferred */
  post(message: ToThread<R>, transfer?: readonly ArrayBuffer[]): void {
    this.#thread.post(message, transfer);
    this.#expect();
  }

  /** Restarts the count of silence, for a message that is expected sooner than others before it. */
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
