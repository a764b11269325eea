/** Workers for pages whose policy demands Trusted Types. */
import {trustedScript} from '../model/trusted.js';

/** Whether a page may have refused a worker for want of trust. */
export const mayWantTrust = (refusal: unknown): boolean =>
  'trustedTypes' in globalThis && refusal instanceof TypeError;

/**
 * Has `make` make its worker from an address that the page trusts. Bundlers put the address where they find a worker
 * made of a URL, and nowhere else: so it is taken from there, while `make` runs.
 * @throws {TypeError} where the page trusts no address of ours
 */
export function madeWithTrust(make: () => Worker): Worker {
  const {Worker: Plain} = globalThis;
  globalThis.Worker = class extends Plain {
    constructor(url: string | URL, options?: WorkerOptions) {
      super(trustedScript(String(url)), options);
    }
  };
  try {
    return make();
  } finally {
    globalThis.Worker = Plain;
  }
}
