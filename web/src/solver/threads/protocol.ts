import type {Failure} from '../../model/failure.js';
import type {KindOf, RequestKinds} from '../requests/kinds.js';

/** Grows with every change of the messages: a page must not talk to a worker from an old cache. */
export const protocolVersion = '6';

/** Starts a job. Its number is the asking thread's and is never used again. */
export interface RequestMessage<R extends RequestKinds, K extends KindOf<R> = KindOf<R>> {
  readonly kind: 'request';
  readonly job: number;
  readonly name: K;
  readonly request: R[K]['request'];
  /** Names of the hooks that somebody listens to. */
  readonly hooks: readonly string[];
  /** How many threads may help. */
  readonly helpers: number;
}

/** Everything the thread that asks may say. */
export type ToThread<R extends RequestKinds> =
  | RequestMessage<R>
  /** By their names, where the modules' files are, or what another thread runs; comes before any job, if at all. */
  | {readonly kind: 'modules'; readonly sources: Readonly<Record<string, ModuleSource>>}
  /** The job is no longer wanted; it still ends with `done` or `failed`. */
  | {readonly kind: 'cancel'; readonly job: number}
  /** To be answered at once, by `pong`. */
  | {readonly kind: 'ping'};

/** An address, or a module to be run as well. */
export type ModuleSource = string | WebAssembly.Module;

/** Everything the thread that answers may say. A job ends with exactly one `done` or `failed`. */
export type FromThread =
  | {readonly kind: 'ready'; readonly version: string}
  | {readonly kind: 'pong'}
  /** What a hook of a job is to be told. */
  | {readonly kind: 'report'; readonly job: number; readonly hook: string; readonly value: unknown}
  | {readonly kind: 'done'; readonly job: number; readonly answer: unknown}
  | {readonly kind: 'failed'; readonly job: number; readonly failure: Failure};
