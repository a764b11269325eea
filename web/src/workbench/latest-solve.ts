/** Solves the newest design only. It replaces the one before, whose results are then ignored. */
import type {Design} from '../model/design/design.js';
import {problemOf} from '../model/documents/design-problem.js';
import {failureOf, SolverError, type Failure} from '../model/base/failure.js';
import type {Progress} from '../model/design/solve-problem.js';
import type {MeshedPattern, SolveResult} from '../model/result/result.js';
import type {SolverService} from '../solver/service.js';

interface SolveListeners {
  pattern(design: Design, pattern: MeshedPattern): void;
  /** Receives angle, x, y per piece. [rad, cm] */
  partial(design: Design, alignments: Float64Array): void;
  progress(design: Design, progress: Progress): void;
  done(design: Design, result: SolveResult): void;
  failed(design: Design, failure: Failure): void;
}

export const toFailure = (error: unknown): Failure => {
  if (error instanceof SolverError) return failureOf(error);
  const message = error instanceof Error ? error.message : String(error);
  return {code: 'internal', message, piece: null, seam: null};
};

/** Least time for each solve while a design changes continuously, such as during a drag. [ms] */
const leastTime = 150;

export class LatestSolve {
  readonly #solver: SolverService;
  readonly #listeners: SolveListeners;
  #current: AbortController | undefined;
  #started = -Infinity;
  /** Timer that starts the next solve. */
  #next: ReturnType<typeof setTimeout> | undefined;

  constructor(solver: SolverService, listeners: SolveListeners) {
    this.#solver = solver;
    this.#listeners = listeners;
  }

  get isRunning(): boolean {
    return this.#current !== undefined || this.#next !== undefined;
  }

  start(design: Design): void {
    clearTimeout(this.#next);
    this.#next = undefined;
    const wait = this.#current ? this.#started + leastTime - performance.now() : 0;
    if (wait > 0) {
      this.#next = setTimeout(() => {
        this.#next = undefined;
        this.#begin(design);
      }, wait);
    } else {
      this.#begin(design);
    }
  }

  cancel(): void {
    clearTimeout(this.#next);
    this.#next = undefined;
    this.#current?.abort();
    this.#current = undefined;
  }

  #begin(design: Design): void {
    this.#current?.abort();
    this.#current = new AbortController();
    this.#started = performance.now();
    void this.#run(design, this.#current);
  }

  async #run(design: Design, controller: AbortController): Promise<void> {
    const {signal} = controller;
    const {name} = design.garment;
    const print = design.print.title;
    try {
      const result = await this.#solver.solve(problemOf(design), {
        signal,
        names: {garment: name, print},
        onPattern: (pattern) => {
          this.#listeners.pattern(design, pattern);
        },
        onPartial: (alignments) => {
          this.#listeners.partial(design, alignments);
        },
        onProgress: (progress) => {
          this.#listeners.progress(design, progress);
        },
      });
      if (signal.aborted) return;
      this.#current = undefined;
      this.#listeners.done(design, result);
    } catch (error) {
      if (signal.aborted) return;
      this.#current = undefined;
      this.#listeners.failed(design, toFailure(error));
    }
  }
}
