/** Progress and intermediate result of the running solve. Both change many times a second. */
import type {Alignment} from '../model/geometry/vectors.js';
import type {Progress} from '../model/design/solve-problem.js';
import {alignmentsFrom} from '../model/geometry/vectors.js';
import {Observable} from './observable.js';

const start: Progress = {phase: 'preparation', fraction: 0};

export class RunningSolve extends Observable {
  #progress = start;
  #partial: readonly Alignment[] | undefined;

  /** Progress of the running or the last solve. */
  get progress(): Progress {
    return this.#progress;
  }

  /** Alignments of the pattern's pieces in the intermediate result. */
  get partial(): readonly Alignment[] | undefined {
    return this.#partial;
  }

  /**
   * Begins another solve. The intermediate result of the one before is still the best known one.
   */
  begin(): void {
    this.#progress = start;
    this.changed();
  }

  proceed(progress: Progress): void {
    this.#progress = progress;
    this.changedOften();
  }

  /** @param alignments angle, x, y per piece, as a solve reports them */
  lay(alignments: Float64Array): void {
    this.#partial = alignmentsFrom(alignments);
    this.changedOften();
  }

  /** Drops the intermediate result. */
  rest(): void {
    if (!this.#partial) return;
    this.#partial = undefined;
    this.changed();
  }
}
