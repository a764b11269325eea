import {Worker} from 'node:worker_threads';

import type {HelperOwner, HelperThread} from '../solver/helpers.js';
import type {FromWorker} from '../solver/protocol.js';

const script = new URL('./helper-thread.js', import.meta.url);

/** A thread of this process, which it does not keep from ending. */
export function thread(owner: HelperOwner): HelperThread {
  const worker = new Worker(script, {stdin: false});
  worker.on('message', (message: FromWorker) => {
    owner.receive(message);
  });
  const lost = () => {
    owner.lost();
  };
  worker.on('error', lost);
  worker.on('exit', lost);
  worker.unref(); // last: a listener to messages would undo it
  return {
    post: (message) => {
      worker.postMessage(message);
    },
    end: () => {
      void worker.terminate();
    },
  };
}
