/// <reference lib="esnext.disposable" preserve="true" />
import {SolverError, type Failure} from '../model/failure.js';
import {internalError} from './broken.js';
import {
  protocolVersion,
  type Answer,
  type Answers,
  type FromWorker,
  type JobRequest,
  type QuestionOf,
} from './protocol.js';
import {TextService, type QuestionHooks} from './service.js';
import {WatchedWorker, type WorkerOwner, type WorkerPlaces} from './watched-worker.js';

export type {NamedPrepareHooks, NamedProofHooks, NamedSolveHooks, ProblemNames} from './texts.js';
export type {GarmentHooks, QuestionHooks, SolverService} from './service.js';
export type {WorkerPlaces} from './watched-worker.js';

/**
 * A worker sees a cancel between two slices, and slices are longer than planned only where a step is: on
 * pieces of many thousand edges. One that has not seen it after this long is replaced, unless it is at work
 * for somebody else as well: whoever comes next need not wait for that step. [ms]
 */
const cancelPatience = 100;

/** For the longest of steps, on a slow device. [ms] */
const workPatience = 10_000;

interface Job {
  readonly request: JobRequest;
  readonly hooks: QuestionHooks;
  /** Whether the worker has reported on it. */
  begun: boolean;
  readonly resolve: (answer: Answer) => void;
  readonly reject: (reason: unknown) => void;
}

/**
 * The solver in a worker of its own, for pages: nothing here keeps the page from drawing. The worker
 * starts with the first call; jobs share it. What a caller hands over is copied, never taken away.
 * A call never stays pending: if the worker breaks, it is rejected, and the next call starts another.
 */
export class SolverClient extends TextService implements Disposable {
  readonly #places: WorkerPlaces;
  readonly #helpers: () => number;
  readonly #jobs = new Map<number, Job>();
  /** Jobs whose callers have gone, and which the worker has not yet dropped. */
  readonly #leaving = new Set<number>();
  readonly #owner: WorkerOwner = {
    receive: (message) => {
      this.#receive(message);
    },
    patience: () => this.#patience(),
    lost: (failure, silent) => {
      this.#lost(failure, silent);
    },
  };
  #worker: WatchedWorker | null = null;
  #lastJob = 0;
  #disposed = false;

  /** @param helpers how many threads may help with a solve just now */
  constructor(places: WorkerPlaces = {}, helpers: () => number = () => 0) {
    super();
    this.#places = places;
    this.#helpers = helpers;
  }

  /** @throws {SolverError} `worker-blocked`, before anything else is heard, if there can be no worker */
  ask<K extends keyof Answers>(question: QuestionOf<K>, hooks: QuestionHooks): Promise<Answers[K]> {
    return new Promise((resolve, reject) => {
      const job = ++this.#lastJob;
      const request = {
        ...question,
        job,
        ...(question.kind === 'solve' && {helpers: this.#helpers()}),
      };
      const {signal} = hooks;
      this.#running().post(request);
      const abort = () => {
        this.#cancel(job, signal?.reason);
      };
      signal?.addEventListener('abort', abort, {once: true});
      this.#jobs.set(job, {
        request,
        hooks,
        begun: false,
        resolve: (answer) => {
          signal?.removeEventListener('abort', abort);
          resolve(answer as Answers[K]);
        },
        reject: (reason) => {
          signal?.removeEventListener('abort', abort);
          // eslint-disable-next-line @typescript-eslint/prefer-promise-reject-errors -- may be the caller's own
          reject(reason);
        },
      });
    });
  }

  /** Ends the worker; what is pending, and what is asked from now on, is rejected as cancelled. */
  dispose(): void {
    this.#disposed = true;
    this.#breakDown({code: 'cancelled', message: 'The solver was disposed of.'});
  }

  [Symbol.dispose](): void {
    this.dispose();
  }

  #running(): WatchedWorker {
    if (this.#disposed) {
      throw new SolverError({code: 'cancelled', message: 'The solver was disposed of.'});
    }
    try {
      return (this.#worker ??= new WatchedWorker(this.#places, this.#owner));
    } catch (error) {
      if (error instanceof SolverError) throw error;
      throw internalError('The solver could not be started', error);
    }
  }

  #receive(message: FromWorker): void {
    switch (message.kind) {
      case 'ready':
        if (message.version !== protocolVersion) {
          const stale = 'The page and its solver are of different versions; load the page again.';
          this.#breakDown({code: 'internal', message: stale});
        }
        break;
      case 'pong':
        break;
      case 'progress': {
        const {job, phase, fraction} = message;
        this.#report(job, (hooks) => hooks.onProgress?.({phase, fraction}));
        break;
      }
      case 'pattern':
        this.#report(message.job, (hooks) => hooks.onPattern?.(message.pattern));
        break;
      case 'partial':
        this.#report(message.job, (hooks) => hooks.onPartial?.(message.alignments));
        break;
      case 'proof':
        this.#report(message.job, (hooks) => hooks.onProof?.(message.proof));
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

  /** A listener that throws ends its job. */
  #report(number: number, tell: (hooks: QuestionHooks) => void): void {
    const job = this.#jobs.get(number);
    if (!job) return;
    job.begun = true;
    try {
      tell(job.hooks);
    } catch (error) {
      this.#cancel(number, error);
    }
  }

  /** A job that ends; none if its caller has gone. */
  #take(number: number): Job | undefined {
    const job = this.#jobs.get(number);
    this.#jobs.delete(number);
    this.#leaving.delete(number);
    return job;
  }

  /** The caller need not wait for the worker to know. */
  #cancel(number: number, reason: unknown): void {
    this.#take(number)?.reject(reason);
    if (this.#leaving.size === 0) this.#worker?.hurry();
    this.#leaving.add(number);
    this.#worker?.post({kind: 'cancel', job: number});
  }

  #patience(): number | null {
    if (this.#jobs.size + this.#leaving.size === 0) return null;
    const wanted = this.#leaving.size === 0 || [...this.#jobs.values()].some((job) => job.begun);
    return wanted ? workPatience : cancelPatience;
  }

  /** A worker that kept silent over a cancelled job takes no job with it that it has not begun. */
  #lost(failure: SolverError, silent: boolean): void {
    const busy = silent && this.#leaving.size > 0;
    const waiting = busy ? [...this.#jobs].filter(([, job]) => !job.begun) : [];
    for (const [number] of waiting) this.#jobs.delete(number);
    this.#breakDown(failure);
    for (const [number, job] of waiting) {
      this.#jobs.set(number, job);
      this.#running().post(job.request);
    }
  }

  /** Nothing more comes from this worker. */
  #breakDown(failure: Pick<Failure, 'code' | 'message'>): void {
    this.#worker?.end();
    this.#worker = null;
    this.#leaving.clear();
    const jobs = [...this.#jobs.values()];
    this.#jobs.clear();
    for (const job of jobs) job.reject(new SolverError(failure));
  }
}
