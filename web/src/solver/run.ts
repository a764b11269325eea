import type {SolveHooks} from '../model/problem.js';
import type {SolveResult} from '../model/result.js';
import {sliceWhileHelped} from './helpers.js';
import type {Solver} from './solver.js';

/** How a solve shares its thread with everything else. */
export interface Pace {
  /** How long it works at a stretch. [ms] */
  readonly slice: number;
  /** Lets pending events run. */
  readonly pause: () => Promise<void>;
}

/** Long enough for pauses not to matter; setTimeout, because a MessageChannel would starve events in Node. */
export const ownThread: Pace = {
  slice: 40,
  pause: () => new Promise((resolve) => setTimeout(resolve, 0)),
};

/**
 * Runs a solver to its end in slices, letting everything else run in between. Does not dispose of it.
 * @param help looks for threads to help; whether any does
 * @throws {SolverError}; the signal's reason, an `AbortError` by default, before the next slice
 */
export async function run(
  solver: Solver,
  hooks: SolveHooks,
  pace: Pace,
  help: () => boolean = () => false,
): Promise<SolveResult> {
  const report = () => {
    hooks.onProgress?.({phase: solver.phase, fraction: solver.fraction});
    hooks.onPartial?.(solver.partial());
  };
  const breathe = async () => {
    await pace.pause();
    hooks.signal?.throwIfAborted();
  };
  await breathe(); // the solver has just been made, which takes longer than most slices
  hooks.onPattern?.(solver.pattern());
  report();
  let more = true;
  while (more) {
    await breathe();
    more = solver.advance(help() ? Math.min(pace.slice, sliceWhileHelped) : pace.slice);
    report();
  }
  await breathe();
  return solver.result();
}
