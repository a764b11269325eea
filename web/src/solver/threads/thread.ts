import type {RequestKinds} from '../requests/kinds.js';
import type {FromThread, ToThread} from './protocol.js';

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
