import {SolverError} from '../../model/result/failure.js';
import type {HooksOf, KindOf, RequestKinds} from '../requests/kinds.js';
import {brokenModule, loadingError} from './broken.js';
import {SharedModule, type Modules, type WasmSources} from './shared-module.js';
import {ownThread, type Pace} from './slices.js';
import type {Answering, AnswerTable, Queue} from './table.js';
import {TaskQueue} from './task-queue.js';
import {unlessAborted} from './unless-aborted.js';

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
  answer<K extends KindOf<R>>(
    kind: K,
    request: R[K]['request'],
    hooks: HooksOf<R[K]>,
  ): Promise<R[K]['answer']> {
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
