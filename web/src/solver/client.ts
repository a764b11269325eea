import {SolverError, type Failure} from '../model/failure.js';
import type {Garment} from '../model/garment.js';
import type {Problem, SolveHooks} from '../model/problem.js';
import type {MeshedPattern, SolveResult} from '../model/result.js';
import type {DetectedSymmetries, MeasuredSymmetry, Symmetry} from '../model/symmetries.js';
import {internalError} from './broken.js';
import {
  protocolVersion,
  type Answer,
  type Answers,
  type FromWorker,
  type JobRequest,
} from './protocol.js';
import {
  jsonText,
  mirrorTexts,
  plainNames,
  problemTexts,
  type NamedPrepareHooks,
  type NamedSolveHooks,
} from './texts.js';
import {WatchedWorker, type WorkerOwner, type WorkerPlaces} from './watched-worker.js';

export type {NamedPrepareHooks, NamedSolveHooks, ProblemNames} from './texts.js';
export type {WorkerPlaces} from './watched-worker.js';

/** For questions about a garment alone. */
export interface GarmentHooks {
  readonly signal?: AbortSignal;
  /** What to call the garment in messages: the name of its file. */
  readonly name?: string;
}

/** A worker sees a cancel between two slices; one that has not after this long is replaced. [ms] */
const cancelPatience = 1000;

/** Reading and meshing cannot be interrupted and take their time on a slow device. [ms] */
const workPatience = 10_000;

interface Job {
  readonly request: JobRequest;
  readonly hooks: SolveHooks;
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
export class SolverClient implements Disposable {
  readonly #places: WorkerPlaces;
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

  constructor(places: WorkerPlaces = {}) {
    this.#places = places;
  }

  /**
   * Aligns a print with a sewing pattern and deforms the pattern so that the print matches at its seams.
   * @throws {SolverError} for bad input; the signal's reason, an `AbortError` by default, when it
   *   fires; what a listener throws
   */
  async solve(problem: Problem, hooks: NamedSolveHooks = {}): Promise<SolveResult> {
    hooks.signal?.throwIfAborted();
    const texts = problemTexts(problem, hooks.names);
    const showsPattern = hooks.onPattern !== undefined;
    return this.#ask<'solve'>({kind: 'solve', job: ++this.#lastJob, texts, showsPattern}, hooks);
  }

  /**
   * The garment as a solve would begin with it: checked, meshed, its symmetries settled.
   * @throws {SolverError} as `solve` does
   */
  async prepare(problem: Problem, hooks: NamedPrepareHooks = {}): Promise<MeshedPattern> {
    hooks.signal?.throwIfAborted();
    const texts = problemTexts(problem, hooks.names);
    return this.#ask<'prepare'>({kind: 'prepare', job: ++this.#lastJob, texts}, hooks);
  }

  /**
   * Measures one symmetry on a garment, whether or not the garment mirrors so.
   * @throws {SolverError} for bad input, such as a piece that the garment does not have
   */
  async mirror(
    garment: Garment | string,
    symmetry: Symmetry,
    {signal, name = plainNames.garment}: GarmentHooks = {},
  ): Promise<MeasuredSymmetry> {
    signal?.throwIfAborted();
    const texts = mirrorTexts(garment, symmetry, name);
    return this.#ask<'mirror'>(
      {kind: 'mirror', job: ++this.#lastJob, texts},
      signal ? {signal} : {},
    );
  }

  /** The symmetries a garment shows by itself: what `symmetry: 'auto'` would impose, group permitting. */
  async symmetries(
    garment: Garment | string,
    hooks: GarmentHooks = {},
  ): Promise<DetectedSymmetries> {
    return this.#askAbout('symmetries', garment, hooks);
  }

  /** A garment of any readable format as the text of a seamwise-garment/1 file. */
  async convert(garment: Garment | string, hooks: GarmentHooks = {}): Promise<string> {
    return this.#askAbout('convert', garment, hooks);
  }

  /** Ends the worker; what is pending, and what is asked from now on, is rejected as cancelled. */
  dispose(): void {
    this.#disposed = true;
    this.#breakDown({code: 'cancelled', message: 'The solver was disposed of.'});
  }

  [Symbol.dispose](): void {
    this.dispose();
  }

  #askAbout<K extends 'symmetries' | 'convert'>(
    kind: K,
    garment: Garment | string,
    {signal, name = plainNames.garment}: GarmentHooks,
  ): Promise<Answers[K]> {
    signal?.throwIfAborted();
    const request = {kind, job: ++this.#lastJob, garment: jsonText(garment, name), name};
    return this.#ask<K>(request, signal ? {signal} : {});
  }

  #ask<K extends keyof Answers>(request: JobRequest, hooks: SolveHooks): Promise<Answers[K]> {
    return new Promise((resolve, reject) => {
      const {job} = request;
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

  #running(): WatchedWorker {
    if (this.#disposed) {
      throw new SolverError({code: 'cancelled', message: 'The solver was disposed of.'});
    }
    try {
      return (this.#worker ??= new WatchedWorker(this.#places, this.#owner));
    } catch (error) {
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
  #report(number: number, tell: (hooks: SolveHooks) => void): void {
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
    if (this.#leaving.size > 0) return cancelPatience;
    return this.#jobs.size > 0 ? workPatience : null;
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
