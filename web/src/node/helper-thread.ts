/** A thread that helps the one that solves: what a nested worker is in a page. */
import {parentPort} from 'node:worker_threads';

import type {FromWorker, ToWorker} from '../solver/protocol.js';
import {serve} from '../solver/worker.js';

const port = parentPort;
if (port) {
  serve({
    postMessage: (message: FromWorker) => {
      port.postMessage(message);
    },
    addEventListener: (_, listener) => {
      port.on('message', (data: ToWorker) => {
        listener({data});
      });
    },
  });
}
