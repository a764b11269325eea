import {trustedScript} from '../../model/base/trusted.js';
import type {Requests} from '../requests/requests.js';
import {workerThread, type StartThread} from '../threads/thread.js';

/**
 * A worker inside this worker, with the same script at a distinguishable URL; it ends with this
 * one.
 */
export const nestedWorker: StartThread<Requests> = (owner) => {
  const address = `${location.href.replace(/#.*/, '')}#helper`;
  return workerThread(new Worker(trustedScript(address), {type: 'module'}), owner);
};
