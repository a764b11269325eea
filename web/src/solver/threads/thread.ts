/** Another thread: its messages, and its interface for the owner. */
import type {KindOf, RequestKinds} from '../requests/requests.js';
import type {Failure} from '../../model/base/failure.js';

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

/** Another thread that answers requests. */
export interface Thread<R extends RequestKinds> {
  /** Sends a message. @throws an error for a message that cannot be copied or transferred */
  post(message: ToThread<R>, transfer?: readonly ArrayBuffer[]): void;
  /** Ends the thread, whatever it is doing; no more messages arrive from it. */
  end(): void;
}

/** Owner of a thread, which receives the thread's messages. */
export interface ThreadOwner {
  receive(message: FromThread): void;
  /** Called when the thread has broken. @param reason empty if unknown */
  lost(reason: string): void;
}

/** Starts a thread. @throws any error if no thread can be started */
export type StartThread<R extends RequestKinds> = (owner: ThreadOwner) => Thread<R>;

/** A browser's worker as a thread. */
export function workerThread<R extends RequestKinds>(
  worker: Worker,
  owner: ThreadOwner,
): Thread<R> {
  const listening = new AbortController();
  const {signal} = listening;
  const receive = ({data}: MessageEvent<FromThread>) => {
    owner.receive(data);
  };
  const lost = (event: Event) => {
    event.preventDefault(); // the page must not report it as its own error, too
    owner.lost(event instanceof ErrorEvent ? event.message : '');
  };
  worker.addEventListener('message', receive, {signal});
  worker.addEventListener('error', lost, {signal});
  worker.addEventListener('messageerror', lost, {signal});
  return {
    post: (message, transfer = []) => {
      worker.postMessage(message, [...transfer]);
    },
    end: () => {
      listening.abort(); // messages still under way belong to ended jobs
      worker.terminate();
    },
  };
}
