import {trustedScript} from '../../model/trusted.js';
import type {Requests} from '../requests/requests.js';
import {workerThread, type StartThread} from '../threads/thread.js';

/** A worker of this worker's, of the same script, told by its address; it ends with this one. */
export const nestedWorker: StartThread<Requests> = (owner) => {
  const address = `${location.href.replace(/#.*/, '')}#helper`;
  return workerThread(new Worker(trustedScript(address), {type: 'module'}), owner);
};
