// Entry of the worker. Hosting it elsewhere requires this file's imports and the .wasm file beside
// it.
import {answering} from './answering.js';
import type {Requests} from './requests/requests.js';
import {Helpers} from './seamwise/helpers.js';
import {nestedWorker} from './seamwise/nested-worker.js';
import type {ToThread} from './threads/protocol.js';
import {serve} from './threads/serve.js';

// Outside a worker this does nothing, such as on a server that follows every import.
if ('DedicatedWorkerGlobalScope' in globalThis) {
  // no helpers where workers cannot start workers
  const helpers = 'Worker' in globalThis ? new Helpers(nestedWorker) : undefined;
  const receive = serve(answering(helpers), (message, transfer) => {
    self.postMessage(message, {transfer});
  });
  self.addEventListener('message', ({data}: MessageEvent<ToThread<Requests>>) => {
    receive(data);
  });
}
