import type {RequestKinds} from '../requests/kinds.js';
import type {FromThread, ToThread} from './protocol.js';

/** Another thread that answers requests. */
export interface Thread<R extends RequestKinds> {
  /** @throws what cannot be copied or transferred */
  post(message: ToThread<R>, transfer?: readonly ArrayBuffer[]): void;
  /** Ends it, whatever it is at; nothing more is heard of it. */
  end(): void;
}

/** Who hears of a thread. */
export interface ThreadOwner {
  receive(message: FromThread): void;
  /** The thread has broken. @param reason empty where nothing is known */
  lost(reason: string): void;
}

/** @throws anything where there can be no thread */
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
    event.preventDefault(); // it need not be reported as the page's own as well
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
      listening.abort(); // what is still under way belongs to jobs of the past
      worker.terminate();
    },
  };
}
