/** Runs solves and proofs in slices. All functions throw the errors of `runInSlices`. */
import type {ProofHooks, SolveHooks} from '../../model/design/solve-problem.js';
import type {MeshedPattern, Proof, SolveResult} from '../../model/result/result.js';
import {runInSlices, type Pace} from '../answers/slices.js';
import type {Solver} from './solver.js';

/** Slice while other threads help, whose answers are needed soon. [ms] */
const sliceWhileHelped = 15;

/** Runs a solver until its garment is ready to be solved. */
function runPreparation(
  solver: Solver,
  {signal, onProgress}: Pick<SolveHooks, 'signal' | 'onProgress'>,
  pace: Pace,
): Promise<void> {
  const work = (milliseconds: number) => {
    onProgress?.({phase: 'preparation', fraction: solver.fraction});
    solver.advance(milliseconds);
    return solver.phase === 'preparation';
  };
  return runInSlices(work, pace, signal);
}

/** Returns the garment in the form to be solved. */
export async function runToPattern(
  solver: Solver,
  hooks: Pick<SolveHooks, 'signal'>,
  pace: Pace,
): Promise<MeshedPattern> {
  await runPreparation(solver, hooks, pace);
  return solver.pattern();
}

/**
 * Runs a solver to its end.
 * @param help searches for threads that can help; returns whether any does
 */
export async function run(
  solver: Solver,
  hooks: SolveHooks,
  pace: Pace,
  help: () => boolean,
): Promise<SolveResult> {
  await runPreparation(solver, hooks, pace);
  hooks.onPattern?.(solver.pattern());
  const report = () => {
    hooks.onProgress?.({phase: solver.phase, fraction: solver.fraction});
    hooks.onPartial?.(solver.partial());
  };
  report();
  const work = (milliseconds: number) => {
    const more = solver.advance(help() ? Math.min(milliseconds, sliceWhileHelped) : milliseconds);
    report();
    return more;
  };
  await runInSlices(work, pace, hooks.signal);
  return solver.result();
}

/**
 * Runs a proof until no more can be proven.
 * @param mayWork returns whether no other work is pending
 */
export async function runProof(
  solver: Solver,
  {signal, onProof}: ProofHooks,
  pace: Pace,
  mayWork: () => boolean,
): Promise<Proof> {
  await runPreparation(solver, {...(signal && {signal})}, pace);
  let told = 0;
  const work = (milliseconds: number): boolean => {
    if (!mayWork()) return true;
    const more = solver.prove(milliseconds);
    const proof = solver.proof();
    if (proof.bound > told) onProof?.(proof);
    told = proof.bound;
    return more;
  };
  await runInSlices(work, pace, signal);
  return solver.proof();
}
