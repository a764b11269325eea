import {Worker} from 'node:worker_threads';

import type {Requests} from '../solver/requests/requests.js';
import type {FromThread, StartThread} from '../solver/threads/thread.js';

const script = new URL('./helper-thread.js', import.meta.url);

/** A thread that does not keep this process alive. */
export const thread: StartThread<Requests> = (owner) => {
  const worker = new Worker(script, {stdin: false});
  worker.on('message', (message: FromThread) => {
    owner.receive(message);
  });
  worker.on('error', (error) => {
    owner.lost(String(error));
  });
  worker.on('exit', () => {
    owner.lost('');
  });
  worker.unref(); // last, since a message listener would undo it
  return {
    post: (message, transfer = []) => {
      worker.postMessage(message, [...transfer]);
    },
    end: () => {
      void worker.terminate();
    },
  };
};
