// The worker's entry; whoever hosts it elsewhere needs this file's imports and the .wasm file beside it.
import {answering} from './answering.js';
import type {Requests} from './requests/requests.js';
import {Helpers} from './seamwise/helpers.js';
import {nestedWorker} from './seamwise/nested-worker.js';
import type {ToThread} from './threads/protocol.js';
import {serve} from './threads/serve.js';

// Where there is nobody to serve, on a server that follows every import, this does nothing.
if ('DedicatedWorkerGlobalScope' in globalThis) {
  // none help where workers cannot start any
  const helpers = 'Worker' in globalThis ? new Helpers(nestedWorker) : undefined;
  const receive = serve(answering(helpers), (message, transfer) => {
    self.postMessage(message, {transfer});
  });
  self.addEventListener('message', ({data}: MessageEvent<ToThread<Requests>>) => {
    receive(data);
  });
}
