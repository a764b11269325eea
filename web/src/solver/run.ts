import type {SolveHooks} from '../model/problem.js';
import type {SolveResult} from '../model/result.js';
import type {Pace} from './pace.js';
import type {Solver} from './solver.js';

/** While others are at work for a solve: what they bring is wanted soon. [ms] */
const sliceWhileHelped = 15;

/** Lets pending events run. @throws the signal's reason, if it has fired by then */
async function breathe(pace: Pace, signal: AbortSignal | undefined): Promise<void> {
  await pace.pause();
  signal?.throwIfAborted();
}

/**
 * Has something work in slices until it has ended, letting everything else run before each of them.
 * @throws {SolverError}; the signal's reason, an `AbortError` by default, before the next slice
 */
export async function runInSlices(
  work: (milliseconds: number) => boolean,
  signal: AbortSignal | undefined,
  pace: Pace,
): Promise<void> {
  do await breathe(pace, signal);
  while (work(pace.slice));
  await breathe(pace, signal);
}

/** Runs a solver in slices until its garment is ready to be solved. @throws as `runInSlices` does */
export function runPreparation(
  solver: Solver,
  {signal, onProgress}: Pick<SolveHooks, 'signal' | 'onProgress'>,
  pace: Pace,
): Promise<void> {
  return runInSlices(
    (milliseconds) => {
      onProgress?.({phase: 'preparation', fraction: solver.fraction});
      solver.advance(milliseconds);
      return solver.phase === 'preparation';
    },
    signal,
    pace,
  );
}

/**
 * Runs a solver to its end in slices. Does not dispose of it.
 * @param help looks for threads to help; whether any does
 * @throws as `runInSlices` does
 */
export async function run(
  solver: Solver,
  hooks: SolveHooks,
  pace: Pace,
  help: () => boolean = () => false,
): Promise<SolveResult> {
  await runPreparation(solver, hooks, pace);
  hooks.onPattern?.(solver.pattern());
  const report = () => {
    hooks.onProgress?.({phase: solver.phase, fraction: solver.fraction});
    hooks.onPartial?.(solver.partial());
  };
  report();
  await runInSlices(
    (milliseconds) => {
      const more = solver.advance(help() ? Math.min(milliseconds, sliceWhileHelped) : milliseconds);
      report();
      return more;
    },
    hooks.signal,
    pace,
  );
  return solver.result();
}
