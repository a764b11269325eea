/** Solves and proofs, run in slices. */
import type {Phase, ProofHooks, SolveHooks} from '../../model/design/solve-problem.js';
import type {MeshedPattern, Milliseconds, Proof, SolveResult} from '../../model/result/result.js';
import {runInSlices, stepsFor, type Pace} from './slices.js';
import {documentBytes, documentValue, toError} from '../json/document.js';
import type {LentShare, ModuleProblem, ModuleSolver, SeamwiseModule} from '../module/seamwise.mjs';
import {namedSymmetries, type ProblemTexts} from '../requests/requests.js';

/**
 * A solve that is advanced slice by slice, including reading its problem. It owns memory of the
 * module, so it must be deleted in any case. Methods may throw a SolverError.
 */
export class Solver {
  readonly #solver: ModuleSolver;
  /** Time of the preparation, and of measuring at the end. [ms] */
  #around = 0;
  readonly #spent = {alignment: 0, deformation: 0, attempts: 0};
  #attempt = 0;
  /** Error that broke the module while shares were exchanged. */
  #broken: Error | null = null;

  constructor(module: SeamwiseModule, problem: ProblemTexts) {
    const started = performance.now();
    this.#solver = new module.Solver(problemDocuments(module, problem));
    this.#around += performance.now() - started;
  }

  /**
   * Works for about `milliseconds`, within one phase; returns false when nothing is left to do.
   * @throws {SolverError} for bad input, during the preparation
   */
  advance(milliseconds: number): boolean {
    if (this.#broken) throw this.#broken;
    const started = performance.now();
    const phase = this.phase;
    let more = true;
    let now = started;
    while (more && now - started < milliseconds && this.phase === phase) {
      const before = now;
      more = this.#solver.advance(1);
      this.#check();
      now = performance.now();
      this.#count(phase, now - before);
    }
    return more;
  }

  /** Adds time to a phase. Only the last attempt at the deformation counts. */
  #count(phase: Phase, milliseconds: number): void {
    if (phase === 'preparation') {
      this.#around += milliseconds;
      return;
    }
    const attempt = this.#solver.attempt();
    if (attempt !== this.#attempt) this.#spent.deformation = 0;
    this.#attempt = attempt;
    this.#spent[phase] += milliseconds;
    if (phase === 'deformation') this.#spent.attempts += milliseconds;
  }

  get phase(): Phase {
    return this.#solver.phase();
  }

  /** Share of the whole solve, from 0 to 1; it never decreases. */
  get fraction(): number {
    return this.#solver.fraction();
  }

  /** The best alignments so far, after the preparation: angle, x, y per piece. A copy. */
  partial(): Float64Array {
    return this.#solver.partial();
  }

  /**
   * A share of the present search for another thread, with its number; null if there is none. The
   * next `advance` throws its errors.
   */
  lend(): LentShare | null {
    return this.#unlessBroken(() => this.#solver.lend());
  }

  /** Returns whether the answers of a lent share are still needed. */
  awaits(number: number): boolean {
    return this.#solver.awaits(number);
  }

  /** Takes the answers of a lent share. The next `advance` throws its errors. */
  take(number: number, answers: Float64Array): void {
    this.#unlessBroken(() => {
      this.#solver.take(number, answers);
    });
  }

  #unlessBroken<T>(work: () => T): T | null {
    try {
      return this.#broken ? null : work();
    } catch (error) {
      this.#broken = error as Error;
      return null;
    }
  }

  /** The meshed garment, after the preparation. */
  pattern(): MeshedPattern {
    const document = this.#solver.pattern();
    this.#check();
    return documentValue(document) as MeshedPattern;
  }

  /** The result, once `advance` has returned false. */
  result(): SolveResult {
    const started = performance.now();
    const document = this.#solver.result();
    this.#check();
    this.#around += performance.now() - started;
    const result = documentValue(document) as SolveResult;
    return {...result, metrics: {...result.metrics, milliseconds: this.milliseconds}};
  }

  /**
   * Proves a bound on alignments for about `milliseconds`; returns false when no more can be
   * proven.
   */
  prove(milliseconds: number): boolean {
    return stepsFor(milliseconds, () => {
      const more = this.#solver.prove(1);
      this.#check();
      return more;
    });
  }

  /** The bound that is proven so far. */
  proof(): Proof {
    return this.#solver.proven();
  }

  /** Time spent computing so far, in whole milliseconds. */
  get milliseconds(): Milliseconds {
    const {alignment, deformation, attempts} = this.#spent;
    return {
      alignment: Math.round(alignment),
      deformation: Math.round(deformation),
      attempts: Math.round(attempts),
      total: Math.round(this.#around + alignment + deformation),
    };
  }

  /** Frees the solver's memory; it cannot be used afterwards. */
  delete(): void {
    this.#solver.delete();
  }

  #check(): void {
    const failure = this.#solver.failure();
    if (failure) throw toError(failure);
  }
}

function problemDocuments(module: SeamwiseModule, texts: ProblemTexts): ModuleProblem {
  const {garment, print, symmetry, options} = texts;
  return {
    ...texts,
    garment: documentBytes(garment, module),
    print: documentBytes(print, module),
    symmetry: namedSymmetries.has(symmetry) ? symmetry : documentBytes(symmetry, module),
    options: options === '' ? '' : documentBytes(options, module),
  };
}

// The functions below throw the errors of `runInSlices`.

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
