/// <reference lib="esnext.disposable" preserve="true" />
import type {ModuleShare, SeamwiseModule} from './module/seamwise.mjs';
import type {Pace} from './run.js';
import {toError} from './solver.js';

/** A share of another thread's search. It owns memory of the module: dispose of it. Every method may throw a SolverError. */
export class Share implements Disposable {
  readonly #share: ModuleShare;

  /** @param order what `Solver.lend` has given */
  constructor(module: SeamwiseModule, order: Float64Array) {
    this.#share = new module.Share(order);
    this.#check();
  }

  /** Runs it to its end, in slices. @returns what `Solver.take` is to be given @throws the signal's reason */
  async run(signal: AbortSignal | undefined, pace: Pace): Promise<Float64Array> {
    for (let more = true; more;) {
      const started = performance.now();
      while (more && performance.now() - started < pace.slice) more = this.#share.advance(1);
      this.#check();
      await pace.pause();
      signal?.throwIfAborted();
    }
    return this.#share.answers();
  }

  [Symbol.dispose](): void {
    this.#share.delete();
  }

  #check(): void {
    const failure = this.#share.failure();
    if (failure) throw toError(failure);
  }
}
