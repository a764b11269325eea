import type {HooksOf, RequestKind, RequestKinds} from '../requests/kinds.js';
import type {ModuleLoader, Modules} from './shared-module.js';
import type {Pace} from './slices.js';

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
export interface Answering<Q extends RequestKind, Ms extends Modules, N extends keyof Ms> {
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

/**
 * All requests that a thread can answer, and their modules, each of which is loaded when it is
 * first needed.
 */
export interface AnswerTable<R extends RequestKinds, Ms extends Modules> {
  readonly modules: {readonly [N in keyof Ms]: ModuleLoader<Ms[N]>};
  readonly requests: {
    readonly [K in keyof R]: {readonly [N in keyof Ms]: Answering<R[K], Ms, N>}[keyof Ms];
  };
}
