import {trustedScript} from '../model/trusted.js';
import type {FromWorker} from './protocol.js';
import type {HelperThread, HelperOwner} from './helpers.js';

/** A worker of this worker's, of the same script, told by its address; it ends with this one. */
export function nestedWorker(owner: HelperOwner): HelperThread {
  const address = `${location.href.replace(/#.*/, '')}#helper`;
  const worker = new Worker(trustedScript(address), {type: 'module'});
  worker.addEventListener('message', ({data}: MessageEvent<FromWorker>) => {
    owner.receive(data);
  });
  for (const kind of ['error', 'messageerror']) {
    worker.addEventListener(kind, (event) => {
      event.preventDefault(); // the solve goes on without it
      owner.lost();
    });
  }
  return {
    post: (message) => {
      worker.postMessage(message);
    },
    end: () => {
      worker.terminate();
    },
  };
}
