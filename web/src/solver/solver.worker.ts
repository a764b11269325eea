// Entry of the worker. Hosting it elsewhere requires this file's imports and the .wasm file beside
// it.
import {answerTable} from './answer-table.js';
import type {Requests} from './requests/requests.js';
import {Helpers} from './threads/helpers.js';
import {workerThread, type StartThread, type ToThread} from './threads/thread.js';
import {serve} from './threads/serve.js';
import {trustedScript} from '../model/base/trusted.js';

/**
 * A worker inside this worker, with the same script, at a distinguishable URL where possible; it
 * ends with this one.
 */
const nestedWorker: StartThread<Requests> = (owner) => {
  // some bundlers pass settings to the script in the fragment
  const address = location.hash === '' ? `${location.href}#helper` : location.href;
  return workerThread(new Worker(trustedScript(address), {type: 'module'}), owner);
};

// Outside a worker this does nothing, such as on a server that follows every import.
if ('DedicatedWorkerGlobalScope' in globalThis) {
  // no helpers where workers cannot start workers
  const helpers = 'Worker' in globalThis ? new Helpers(nestedWorker) : undefined;
  const receive = serve(answerTable(helpers), (message, transfer) => {
    self.postMessage(message, {transfer});
  });
  self.addEventListener('message', ({data}: MessageEvent<ToThread<Requests>>) => {
    receive(data);
  });
}
