/** How far the solve is that is under way, and what its answer looks like by then. Both come many times a second. */
import type {Alignment} from '../model/geometry.js';
import type {Progress} from '../model/problem.js';
import {alignmentsFrom} from '../scene/scene.js';
import {Observable} from './observable.js';

const start: Progress = {phase: 'preparation', fraction: 0};

export class RunningSolve extends Observable {
  #progress = start;
  #partial: readonly Alignment[] | undefined;

  /** Of the solve that is under way, or was last. */
  get progress(): Progress {
    return this.#progress;
  }

  /** How the pieces lie in the answer that is on its way; of the pattern's pieces. */
  get partial(): readonly Alignment[] | undefined {
    return this.#partial;
  }

  /** Another solve; what the one before had found is still the best that is known. */
  begin(): void {
    this.#progress = start;
    this.changed();
  }

  proceed(progress: Progress): void {
    this.#progress = progress;
    this.changedOften();
  }

  /** @param alignments as a solve reports them */
  lay(alignments: Float64Array): void {
    this.#partial = alignmentsFrom(alignments);
    this.changedOften();
  }

  /** No answer is on its way any more. */
  rest(): void {
    if (!this.#partial) return;
    this.#partial = undefined;
    this.changed();
  }
}
