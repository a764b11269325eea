/// <reference lib="esnext.disposable" preserve="true" />
import type {ModuleShare, SeamwiseModule} from './module/seamwise.mjs';
import {toError} from './solver.js';

/** A share of another thread's search. It owns memory of the module: dispose of it. Methods may throw a SolverError. */
export class Share implements Disposable {
  readonly #share: ModuleShare;

  /** @param order what `Solver.lend` has given */
  constructor(module: SeamwiseModule, order: Float64Array) {
    this.#share = new module.Share(order);
  }

  /** Works for about `milliseconds`; false when there is nothing left to do. */
  advance(milliseconds: number): boolean {
    const started = performance.now();
    let more = true;
    while (more && performance.now() - started < milliseconds) more = this.#share.advance(1);
    const failure = this.#share.failure();
    if (failure) throw toError(failure);
    return more;
  }

  /** What `Solver.take` is to be given, once `advance` has returned false. */
  answers(): Float64Array {
    return this.#share.answers();
  }

  [Symbol.dispose](): void {
    this.#share.delete();
  }
}
