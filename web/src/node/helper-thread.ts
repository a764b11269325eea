/** A thread that helps the solver, like a nested worker in a page. */
import {parentPort} from 'node:worker_threads';

import {answerTable} from '../solver/answer-table.js';
import {serve} from '../solver/threads/serve.js';

const port = parentPort;
port?.on(
  'message',
  serve(answerTable(), (message, transfer) => {
    port.postMessage(message, transfer);
  }),
);
