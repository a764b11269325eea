import type {Failure} from '../../model/result/failure.js';
import type {KindOf, RequestKinds} from '../requests/kinds.js';

/** Increases with every change of the messages: a page must not use a worker from an old cache. */
export const protocolVersion = '6';

/** Starts a job. The sender chooses its number and never uses it again. */
export interface RequestMessage<R extends RequestKinds, K extends KindOf<R> = KindOf<R>> {
  readonly kind: 'request';
  readonly job: number;
  readonly name: K;
  readonly request: R[K]['request'];
  /** Names of the hooks that have callbacks. */
  readonly hooks: readonly string[];
  /** Number of threads that may help. */
  readonly helpers: number;
}

/** All messages to the answering thread. */
export type ToThread<R extends RequestKinds> =
  | RequestMessage<R>
  /**
   * Sources of modules by name: URLs, or modules that another thread runs. They come before any
   * job, if at all.
   */
  | {readonly kind: 'modules'; readonly sources: Readonly<Record<string, ModuleSource>>}
  /** The job is no longer needed; it still ends with `done` or `failed`. */
  | {readonly kind: 'cancel'; readonly job: number}
  /** Requires `pong` as an immediate answer. */
  | {readonly kind: 'ping'};

/** A URL, or a compiled module. */
export type ModuleSource = string | WebAssembly.Module;

/** All messages from the answering thread. A job ends with exactly one `done` or `failed`. */
export type FromThread =
  | {readonly kind: 'ready'; readonly version: string}
  | {readonly kind: 'pong'}
  /** Value for a hook of a job. */
  | {readonly kind: 'report'; readonly job: number; readonly hook: string; readonly value: unknown}
  | {readonly kind: 'done'; readonly job: number; readonly answer: unknown}
  | {readonly kind: 'failed'; readonly job: number; readonly failure: Failure};
