// The worker's entry; whoever hosts it elsewhere needs this file's imports and the .wasm file beside it.
import {serve} from './worker.js';

// Where there is nobody to serve, on a server that follows every import, this does nothing.
if ('DedicatedWorkerGlobalScope' in globalThis) serve(self);
