/** Sends requests to another thread, and watches it. */
import {SolverError, type Failure} from '../../model/base/failure.js';
import {internalError} from '../answers/failures.js';
import type {HooksOf, KindOf, RequestKinds} from '../requests/requests.js';
import {
  protocolVersion,
  type FromThread,
  type RequestMessage,
  type StartThread,
  type Thread,
  type ToThread,
} from './thread.js';

/**
 * Time limit for the reaction to a cancellation. A worker reacts between two slices. Slices are
 * longer than planned only where a single step is: on pieces of many thousand edges. A worker that
 * exceeds the limit is replaced, unless it also works on another job, so that the next job need not
 * wait for that step. [ms]
 */
const cancelPatience = 100;

/** Time limit for the longest step on a slow device. [ms] */
const workPatience = 10_000;

const disposedOf = {code: 'cancelled', message: 'The solver was disposed of.'} as const;

interface Job<R extends RequestKinds> {
  readonly message: RequestMessage<R>;
  readonly transfer: readonly ArrayBuffer[];
  readonly hear: (hook: string, value: unknown) => void;
  posted: boolean;
  /** True if the thread has reported on the job. */
  begun: boolean;
  readonly resolve: (answer: unknown) => void;
  readonly reject: (reason: unknown) => void;
  /** Removes the job's listener from its signal. */
  readonly unlisten: () => void;
}

/**
 * Sends requests to another thread, which is started with the first request. A request never stays
 * pending: if the thread breaks, the request is rejected, and the next one starts another thread.
 */
export class ThreadClient<R extends RequestKinds> {
  readonly #start: ThreadStart<R>;
  readonly #jobs = new Map<number, Job<R>>();
  /** Jobs that their callers have cancelled and the thread has not yet dropped. */
  readonly #leaving = new Set<number>();
  readonly #owner: WatchOwner = {
    receive: (message) => {
      this.#receive(message);
    },
    patience: () => this.#patience(),
    lost: (failure, silent) => {
      this.#lost(failure, silent);
    },
  };
  #thread: WatchedThread<R> | null = null;
  /** True if the thread has confirmed the protocol version. No job is sent to it before. */
  #ready = false;
  #lastJob = 0;
  #disposed = false;

  constructor(start: ThreadStart<R>) {
    this.#start = start;
  }

  /**
   * Sends a request.
   * @throws {SolverError}, such as for a thread that cannot be started, before any hook is called;
   * the signal's reason
   */
  ask<K extends KindOf<R>>(
    kind: K,
    request: R[K]['request'],
    hooks: HooksOf<R[K]>,
  ): Promise<R[K]['answer']> {
    return new Promise((resolve, reject) => {
      const {signal, transfer = [], helpers = 0} = hooks;
      signal?.throwIfAborted();
      const number = ++this.#lastJob;
      const listeners = listenersOf(hooks);
      const abort = () => {
        this.#cancel(number, signal?.reason);
      };
      const job: Job<R> = {
        message: {
          ...{kind: 'request', job: number, name: kind, request, helpers},
          hooks: [...listeners.keys()],
        },
        transfer,
        hear: (hook, value) => listeners.get(hook)?.(value),
        posted: false,
        begun: false,
        resolve,
        reject,
        unlisten: () => signal?.removeEventListener('abort', abort),
      };
      this.#run();
      signal?.addEventListener('abort', abort, {once: true});
      this.#jobs.set(number, job);
      if (this.#ready) this.#post(number, job);
    });
  }

  /** Ends the thread. Pending requests and all later ones are rejected as cancelled. */
  dispose(): void {
    this.#disposed = true;
    this.#breakDown(disposedOf);
  }

  #run(): void {
    if (this.#disposed) throw new SolverError(disposedOf);
    if (this.#thread) return;
    try {
      this.#thread = new WatchedThread(this.#start, this.#owner);
    } catch (error) {
      if (error instanceof SolverError) throw error;
      throw internalError('The solver could not be started', error);
    }
  }

  #post(number: number, job: Job<R>): void {
    try {
      this.#thread?.post(job.message, job.transfer);
      job.posted = true;
    } catch (error) {
      this.#take(number)?.reject(unsendable(job.message.name, error));
    }
  }

  #receive(message: FromThread): void {
    switch (message.kind) {
      case 'ready':
        this.#begin(message.version);
        break;
      case 'pong':
        break;
      case 'report':
        this.#report(message.job, message.hook, message.value);
        break;
      case 'done':
        this.#take(message.job)?.resolve(message.answer);
        break;
      case 'failed':
        this.#take(message.job)?.reject(new SolverError(message.failure));
        if (message.failure.code === 'internal') this.#breakDown(message.failure);
        break;
      default:
        message satisfies never;
    }
  }

  #begin(version: string): void {
    if (version !== protocolVersion) {
      const stale = 'The page and its solver are of different versions; load the page again.';
      this.#breakDown({code: 'internal', message: stale});
      return;
    }
    this.#ready = true;
    for (const [number, job] of this.#jobs) this.#post(number, job);
  }

  /** Calls a hook. A hook that throws ends its job. */
  #report(number: number, hook: string, value: unknown): void {
    const job = this.#jobs.get(number);
    if (!job) return;
    job.begun = true;
    try {
      job.hear(hook, value);
    } catch (error) {
      this.#cancel(number, error);
    }
  }

  /** Removes and returns an ending job; undefined if its caller has cancelled it. */
  #take(number: number): Job<R> | undefined {
    const job = this.#jobs.get(number);
    job?.unlisten();
    this.#jobs.delete(number);
    this.#leaving.delete(number);
    return job;
  }

  /** Cancels a job. The caller need not wait for the thread's confirmation. */
  #cancel(number: number, reason: unknown): void {
    const job = this.#take(number);
    job?.reject(reason);
    if (!job?.posted) return;
    if (this.#leaving.size === 0) this.#thread?.hurry();
    this.#leaving.add(number);
    this.#thread?.post({kind: 'cancel', job: number});
  }

  #patience(): number | null {
    if (this.#jobs.size + this.#leaving.size === 0) return null;
    const wanted = this.#leaving.size === 0 || [...this.#jobs.values()].some((job) => job.begun);
    return wanted ? workPatience : cancelPatience;
  }

  /**
   * Replaces a lost thread. If it was silent over a cancelled job, the jobs that it has not begun
   * go to the next thread, unless their buffers were transferred to it.
   */
  #lost(failure: SolverError, silent: boolean): void {
    const busy = silent && this.#leaving.size > 0;
    const waiting = [...this.#jobs].filter(
      ([, job]) => busy && !job.begun && job.transfer.length === 0,
    );
    for (const [number] of waiting) this.#jobs.delete(number);
    this.#breakDown(failure);
    for (const [number, job] of waiting) this.#jobs.set(number, {...job, posted: false});
    if (waiting.length === 0) return;
    try {
      this.#run();
    } catch (error) {
      this.#breakDown(error as SolverError);
    }
  }

  /** Ends this thread and rejects its jobs. */
  #breakDown(failure: Pick<Failure, 'code' | 'message'>): void {
    this.#thread?.end();
    this.#thread = null;
    this.#ready = false;
    this.#leaving.clear();
    for (const number of [...this.#jobs.keys()]) {
      this.#take(number)?.reject(new SolverError(failure));
    }
  }
}

/** Error for a request that cannot be copied to another thread. */
const unsendable = (name: string, cause: unknown): SolverError =>
  new SolverError(
    {
      code: 'options',
      message: `${name}: a part of its arguments cannot be sent to the solver's thread; pass plain values.`,
    },
    {cause},
  );

/** Callbacks of a request, by the names of its hooks. `onBegin` is always among them. */
function listenersOf(hooks: object): Map<string, (value: unknown) => void> {
  const listeners = new Map<string, (value: unknown) => void>([['onBegin', () => undefined]]);
  const entries: [string, unknown][] = Object.entries(hooks);
  for (const [name, hook] of entries) {
    if (typeof hook === 'function') listeners.set(name, hook as (value: unknown) => void);
  }
  return listeners;
}

/** Owner of a watched thread. */
interface WatchOwner {
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
class WatchedThread<R extends RequestKinds> {
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
