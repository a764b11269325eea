/**
 * Searches for better answers to a solved design: among sizes and turns of its print, and with other
 * seeds. Their answers are offered, and change nothing by themselves.
 */
import type {Design} from '../model/design/design.js';
import type {SolveResult} from '../model/result/result.js';
import type {SolverService} from '../solver/service.js';
import {maySpend} from './considerate.js';
import {IdleSolver} from './idle-solver.js';
import {LongerSearch, type BetterMatch} from './longer-search.js';
import {Observable} from './observable.js';
import {PrintSizes, type PrintComparison} from './print-sizes.js';

export type SearchKind = 'sizes' | 'longer';

/** Sizes come first: per solve, they make more seams match than seeds do. */
const kinds: readonly SearchKind[] = ['sizes', 'longer'];

export class Searches extends Observable {
  readonly #solver: IdleSolver;
  readonly #searches: {readonly sizes: PrintSizes; readonly longer: LongerSearch};
  #latest: Design | undefined;

  /** @param keep stores a result that may be offered, so that it is shown without a solve */
  constructor(solver: SolverService, keep: (design: Design, result: SolveResult) => void) {
    super();
    const changed = (): void => {
      this.changed();
    };
    this.#solver = new IdleSolver(solver, keep);
    this.#searches = {
      sizes: new PrintSizes(this.#solver, changed),
      longer: new LongerSearch(this.#solver, changed),
    };
  }

  /** A better answer to the design, which the user may take. */
  better(design: Design): BetterMatch | undefined {
    return this.#searches.longer.better(design);
  }

  /** Comparison of sizes and turns of the print; undefined before it begins. */
  printSizes(design: Design): PrintComparison | undefined {
    return this.#searches.sizes.of(design);
  }

  isRunning(kind: SearchKind, design: Design): boolean {
    return this.#searches[kind].isRunning(design);
  }

  /** Sizes of the print that a shop offers, as multiples of its own; undefined without a shop. */
  get offeredSizes(): readonly number[] | undefined {
    return this.#searches.sizes.offered;
  }

  set offeredSizes(sizes: readonly number[] | undefined) {
    this.#searches.sizes.offered = sizes;
  }

  /** Returns whether there are other sizes or turns of the print. */
  hasOtherSizes(design: Design): boolean {
    return this.#searches.sizes.hasOthers(design);
  }

  /** Searches for better answers until there is another request, if the device permits. */
  async follow(design: Design, result: SolveResult): Promise<void> {
    this.#begin(design, result);
    if (!(await maySpend())) return;
    for (const kind of kinds) {
      if (this.#latest === design) await this.#searches[kind].follow(design);
    }
  }

  /** Searches at the user's request. */
  async request(kind: SearchKind, design: Design, result: SolveResult): Promise<void> {
    this.#begin(design, result);
    this.#searches[kind].allow(design);
    await this.#searches[kind].follow(design);
  }

  /** Ends a search of a design at the user's request; the answers so far stay. */
  end(kind: SearchKind, design: Design): void {
    this.#searches[kind].end(design);
  }

  stop(): void {
    this.#latest = undefined;
    for (const kind of kinds) this.#searches[kind].stop();
  }

  #begin(design: Design, result: SolveResult): void {
    this.stop();
    this.#latest = design;
    this.#solver.learn(design, result);
  }
}
