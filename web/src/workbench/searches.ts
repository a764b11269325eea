/**
 * Searches for better answers to a solved design: among sizes and turns of its print, and with other
 * seeds. Their answers are offered, and change nothing by themselves.
 */
import type {Design} from '../model/design/design.js';
import type {SolveResult} from '../model/result/result.js';
import type {SolverService} from '../solver/service.js';
import {maySpend} from './considerate.js';
import type {BetterAnswers} from './better-answers.js';
import type {BetterMatch} from './longer-search.js';
import {Observable} from './observable.js';
import {hasOtherSizes} from './other-sizes.js';
import type {PrintComparison} from './print-sizes.js';

export type SearchKind = 'sizes' | 'longer';

/** Sizes come first: per solve, they make more seams match than seeds do. */
const kinds: readonly SearchKind[] = ['sizes', 'longer'];

export class Searches extends Observable {
  /** Sizes of the print that a shop offers, as multiples of its own; undefined without a shop. */
  offeredSizes: readonly number[] | undefined;
  readonly #load: () => Promise<BetterAnswers>;
  #loading: Promise<BetterAnswers> | undefined;
  /** Undefined before the first search. */
  #answers: BetterAnswers | undefined;
  #latest: Design | undefined;

  /** @param keep stores a result that may be offered, so that it is shown without a solve */
  constructor(solver: SolverService, keep: (design: Design, result: SolveResult) => void) {
    super();
    this.#load = async () => {
      const {betterAnswers} = await import('./better-answers.js');
      return betterAnswers(
        solver,
        keep,
        () => {
          this.changed();
        },
        () => this.offeredSizes,
      );
    };
  }

  /** A better answer to the design, which the user may take. */
  better(design: Design): BetterMatch | undefined {
    return this.#answers?.longer.better(design);
  }

  /** Comparison of sizes and turns of the print; undefined before it begins. */
  printSizes(design: Design): PrintComparison | undefined {
    return this.#answers?.sizes.of(design);
  }

  isRunning(kind: SearchKind, design: Design): boolean {
    return this.#answers?.[kind].isRunning(design) ?? false;
  }

  /** Returns whether there are other sizes or turns of the print. */
  hasOtherSizes(design: Design): boolean {
    return hasOtherSizes(design, this.offeredSizes);
  }

  /** Searches for better answers until there is another request, if the device permits. */
  async follow(design: Design, result: SolveResult): Promise<void> {
    this.#begin(design);
    if (!(await maySpend())) return;
    for (const kind of kinds) await this.#search(kind, design, result);
  }

  /** Searches at the user's request. */
  async request(kind: SearchKind, design: Design, result: SolveResult): Promise<void> {
    this.#begin(design);
    await this.#search(kind, design, result, true);
  }

  /** Ends a search of a design at the user's request; the answers so far stay. */
  end(kind: SearchKind, design: Design): void {
    this.#answers?.[kind].end(design);
  }

  stop(): void {
    this.#latest = undefined;
    for (const kind of kinds) this.#answers?.[kind].stop();
  }

  #begin(design: Design): void {
    this.stop();
    this.#latest = design;
  }

  async #search(
    kind: SearchKind,
    design: Design,
    result: SolveResult,
    isAsked = false,
  ): Promise<void> {
    if (this.#latest !== design) return;
    const answers = await this.#loaded();
    if (this.#latest !== design || !answers) return;
    answers.solver.learn(design, result);
    if (isAsked) answers[kind].allow(design);
    await answers[kind].follow(design);
  }

  /** Undefined if the code is out of reach; the next search tries again. */
  async #loaded(): Promise<BetterAnswers | undefined> {
    this.#loading ??= this.#load();
    try {
      this.#answers = await this.#loading;
    } catch {
      this.#loading = undefined;
    }
    return this.#answers;
  }
}
