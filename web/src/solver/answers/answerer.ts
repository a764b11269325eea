/** Answers requests on the calling thread: queues, modules, and the table of answers. */
import {checkArguments} from '../../model/base/arguments.js';
import {SolverError} from '../../model/base/failure.js';
import type {Read} from '../../model/base/read.js';
import type {HooksOf, KindOf, RequestKind, RequestKinds} from '../requests/requests.js';
import {brokenModule, loadingError, unlessAborted} from './failures.js';
import {
  SharedModule,
  type ModuleLoader,
  type Modules,
  type WasmSources,
} from '../module/shared-module.js';
import {ownThread, type Pace} from './slices.js';

/** Requests that wait for each other, in the order of arrival. */
export interface Queue {
  /** Number of requests that are answered at the same time. */
  readonly atOnce: number;
}

/** A request that is being answered. */
interface Job<Q extends RequestKind> {
  readonly hooks: HooksOf<Q>;
  readonly pace: Pace;
  /** The compiled module, so that other threads run exactly the same one. */
  readonly compiled: WebAssembly.Module | undefined;
  /** Returns whether no request of a queue is being answered. */
  readonly isIdle: (queue: Queue) => boolean;
}

/** Answers requests of one kind. */
interface Answering<Q extends RequestKind, Ms extends Modules, N extends keyof Ms> {
  readonly module: N;
  /** Queue in which a request waits; without one it starts at once. */
  readonly queue?: Queue;
  /**
   * Values whose typed arrays are transferred to another thread instead of copied. They must not be
   * views of the module's memory.
   */
  readonly transfers?: readonly ('answer' | keyof Q['hooks'])[];
  /**
   * Answers a request.
   * @throws {SolverError}, where `internal` replaces the module; the signal's reason, when it has
   * fired
   */
  answer(module: Ms[N], request: Q['request'], job: Job<Q>): Q['answer'] | Promise<Q['answer']>;
}

type Checks<R extends RequestKinds> = {readonly [K in keyof R]?: Read<R[K]['request']>};

/**
 * All requests that a thread can answer, and their modules, each of which is loaded when it is
 * first needed.
 */
export interface AnswerTable<R extends RequestKinds, Ms extends Modules> {
  readonly modules: {readonly [N in keyof Ms]: ModuleLoader<Ms[N]>};
  /** Checks of the requests, before anything else. */
  readonly checks: Checks<R>;
  /** Checks that load with their first request. */
  laterChecks?(): Promise<Checks<R>>;
  readonly requests: {
    readonly [K in keyof R]: {readonly [N in keyof Ms]: Answering<R[K], Ms, N>}[keyof Ms];
  };
}

export interface AnswererOptions<Ms extends Modules> {
  /** Sources of the modules; a page or worker needs none. */
  readonly sources?: WasmSources<Ms>;
  readonly pace?: Pace;
  /** Time limit for loading a module. [ms] */
  readonly patience?: number;
}

/** Answers requests on the calling thread, with one instance of each module that they need. */
export class Answerer<R extends RequestKinds, Ms extends Modules> {
  readonly #table: AnswerTable<R, Ms>;
  readonly #options: AnswererOptions<Ms>;
  readonly #modules = new Map<keyof Ms, SharedModule<Ms[keyof Ms]>>();
  readonly #queues = new Map<Queue, TaskQueue>();

  constructor(table: AnswerTable<R, Ms>, options: AnswererOptions<Ms> = {}) {
    this.#table = table;
    this.#options = options;
  }

  /** Answers a request. @throws {SolverError}; the signal's reason, as soon as it fires */
  async answer<K extends KindOf<R>>(
    kind: K,
    request: R[K]['request'],
    hooks: HooksOf<R[K]>,
  ): Promise<R[K]['answer']> {
    const table = this.#table;
    const check = table.checks[kind] ?? (await table.laterChecks?.())?.[kind];
    if (!check) throw new Error(`No check for requests '${kind}'.`);
    checkArguments(kind, ['request', request, check]);
    const answering: Answering<R[K], Ms, keyof Ms> = this.#table.requests[kind];
    const {queue} = answering;
    const work = () => this.#onModule(answering, request, hooks);
    return queue ? this.#queue(queue).take(work, hooks.signal) : work();
  }

  /**
   * Answers a request with its module. An instance that broke, or ran out of memory, is discarded.
   */
  async #onModule<K extends KindOf<R>>(
    answering: Answering<R[K], Ms, keyof Ms>,
    request: R[K]['request'],
    hooks: HooksOf<R[K]>,
  ): Promise<R[K]['answer']> {
    const shared = this.#module(answering.module);
    const module = await unlessAborted(load(shared), hooks.signal);
    try {
      hooks.onBegin?.();
      return await answering.answer(module, request, {
        hooks,
        pace: this.#options.pace ?? ownThread,
        compiled: shared.compiled,
        isIdle: (queue) => this.#queue(queue).isIdle,
      });
    } catch (error) {
      if (error instanceof WebAssembly.RuntimeError) {
        shared.discard();
        throw brokenModule(error);
      }
      if (error instanceof SolverError && error.code === 'internal') shared.discard();
      throw error;
    }
  }

  #module(name: keyof Ms): SharedModule<Ms[keyof Ms]> {
    const {sources, patience} = this.#options;
    // eslint-disable-next-line @typescript-eslint/no-unsafe-enum-assignment -- names are no enum
    const loader = this.#table.modules[name];
    const shared = this.#modules.get(name) ?? new SharedModule(loader, sources?.[name], patience);
    this.#modules.set(name, shared);
    return shared;
  }

  #queue(queue: Queue): TaskQueue {
    const tasks = this.#queues.get(queue) ?? new TaskQueue(queue.atOnce);
    this.#queues.set(queue, tasks);
    return tasks;
  }
}

async function load<M>(shared: SharedModule<M>): Promise<M> {
  try {
    return await shared.load();
  } catch (error) {
    throw loadingError(error, shared.file);
  }
}

/** Runs a limited number of tasks at a time, in the order of arrival. */
export class TaskQueue {
  readonly #atOnce: number;
  #free: number;
  /** Functions that start the waiting tasks, in order. */
  readonly #waiting = new Set<() => void>();

  /** @param atOnce greatest number of tasks that run at the same time */
  constructor(atOnce: number) {
    this.#atOnce = this.#free = atOnce;
  }

  get isIdle(): boolean {
    return this.#free === this.#atOnce;
  }

  /**
   * Runs a task in its turn.
   * @throws errors of `work`; the signal's reason, at once, when it fires before the task's turn
   */
  async take<T>(work: () => Promise<T>, signal?: AbortSignal): Promise<T> {
    signal?.throwIfAborted();
    if (this.#free > 0) this.#free -= 1;
    else await this.#wait(signal);
    try {
      return await work();
    } finally {
      this.#pass();
    }
  }

  #wait(signal: AbortSignal | undefined): Promise<void> {
    return new Promise((resolve, reject) => {
      const leave = () => {
        this.#waiting.delete(begin);
        // eslint-disable-next-line @typescript-eslint/prefer-promise-reject-errors -- the caller's own
        reject(signal?.reason);
      };
      const begin = () => {
        signal?.removeEventListener('abort', leave);
        resolve();
      };
      this.#waiting.add(begin);
      signal?.addEventListener('abort', leave, {once: true});
    });
  }

  #pass(): void {
    const [next] = this.#waiting;
    if (!next) {
      this.#free += 1;
      return;
    }
    this.#waiting.delete(next);
    next();
  }
}
