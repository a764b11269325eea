// The worker's entry; whoever hosts it elsewhere needs this file's imports and the .wasm file beside it.
import {serve} from './worker.js';

serve(self);
