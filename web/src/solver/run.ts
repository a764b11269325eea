import type {SolveHooks} from '../model/problem.js';
import type {SolveResult} from '../model/result.js';
import type {Solver} from './solver.js';

/** Short enough for a page to stay responsive, long enough for pauses not to matter. [ms] */
const sliceMilliseconds = 40;

/**
 * Runs a solver to its end in slices, letting everything else run in between. Does not dispose of it.
 * @throws {SolverError}; the signal's reason, an `AbortError` by default, as soon as it fires
 */
export async function run(solver: Solver, hooks: SolveHooks): Promise<SolveResult> {
  const report = () => {
    hooks.onProgress?.({phase: solver.phase, fraction: solver.fraction});
    hooks.onPartial?.(solver.partial());
  };
  hooks.onPattern?.(solver.pattern());
  report();
  let more = true;
  while (more) {
    await pause(hooks.signal);
    more = solver.advance(sliceMilliseconds);
    report();
  }
  return solver.result();
}

/** Lets pending events run; setTimeout, because a MessageChannel would starve them in Node. */
function pause(signal: AbortSignal | undefined): Promise<void> {
  return new Promise((resolve, reject) => {
    const abort = () => {
      clearTimeout(timer);
      // eslint-disable-next-line @typescript-eslint/prefer-promise-reject-errors -- the caller's own
      reject(signal?.reason);
    };
    const timer = setTimeout(() => {
      signal?.removeEventListener('abort', abort);
      resolve();
    }, 0);
    if (signal?.aborted) abort();
    else signal?.addEventListener('abort', abort, {once: true});
  });
}
