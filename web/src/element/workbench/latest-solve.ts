/** Solves the newest design only: a new one takes the place of the one before, whose answers are heard no more. */
import {problemOf, type Design} from '../../model/design.js';
import {SolverError, type Failure} from '../../model/failure.js';
import type {Progress} from '../../model/problem.js';
import type {MeshedPattern, SolveResult} from '../../model/result.js';
import type {SolverClient} from '../../solver/client.js';

export interface SolveListeners {
  pattern(design: Design, pattern: MeshedPattern): void;
  /** Angle, x, y per piece. [rad, cm] */
  partial(design: Design, alignments: Float64Array): void;
  progress(design: Design, progress: Progress): void;
  done(design: Design, result: SolveResult): void;
  failed(design: Design, failure: Failure): void;
}

export const toFailure = (error: unknown): Failure => {
  if (error instanceof SolverError) {
    const {code, message, piece, seam} = error;
    return {code, message, piece, seam};
  }
  const message = error instanceof Error ? error.message : String(error);
  return {code: 'internal', message, piece: null, seam: null};
};

export class LatestSolve {
  readonly #client: SolverClient;
  readonly #listeners: SolveListeners;
  #current: AbortController | undefined;

  constructor(client: SolverClient, listeners: SolveListeners) {
    this.#client = client;
    this.#listeners = listeners;
  }

  get isRunning(): boolean {
    return this.#current !== undefined;
  }

  start(design: Design): void {
    this.cancel();
    const controller = new AbortController();
    this.#current = controller;
    void this.#run(design, controller);
  }

  cancel(): void {
    this.#current?.abort();
    this.#current = undefined;
  }

  async #run(design: Design, controller: AbortController): Promise<void> {
    const {signal} = controller;
    const {name} = design.garment;
    const print = design.print.title;
    try {
      const result = await this.#client.solve(problemOf(design), {
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
