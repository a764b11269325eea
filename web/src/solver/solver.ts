/// <reference lib="esnext.disposable" preserve="true" />
import {symmetryReasons} from '../model/notes.js';
import {failureCode, SolverError} from '../model/failure.js';
import type {Phase} from '../model/problem.js';
import type {MeshedPattern, Milliseconds, SolveResult} from '../model/result.js';
import type {ProblemTexts} from './texts.js';
import type {
  LentShare,
  ModuleFailure,
  ModuleSolver,
  ModuleText,
  SeamwiseModule,
} from './module/seamwise.mjs';

/**
 * A solve that is advanced slice by slice. It owns memory of the module: dispose of it, whatever
 * happens. Methods may throw a SolverError.
 */
export class Solver implements Disposable {
  readonly #solver: ModuleSolver;
  /** Outside the phases: reading, meshing, measuring. [ms] */
  #around = 0;
  readonly #spent: Record<Phase, number> = {alignment: 0, deformation: 0};
  #attempt = 0;

  /** @throws {SolverError} for bad input */
  constructor(module: SeamwiseModule, problem: ProblemTexts) {
    const started = performance.now();
    this.#solver = new module.Solver(problem);
    this.#around += performance.now() - started;
    try {
      this.#check();
    } catch (error) {
      this.#solver.delete();
      throw error;
    }
  }

  /** Works for about `milliseconds`, within one phase; false when there is nothing left to do. */
  advance(milliseconds: number): boolean {
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

  /** Only the last attempt at the deformation counts. */
  #count(phase: Phase, milliseconds: number): void {
    const attempt = this.#solver.attempt();
    if (attempt !== this.#attempt) this.#spent.deformation = 0;
    this.#attempt = attempt;
    this.#spent[phase] += milliseconds;
  }

  get phase(): Phase {
    return this.#solver.phase();
  }

  /** Of the whole solve, from 0 to 1; never falls. */
  get fraction(): number {
    return this.#solver.fraction();
  }

  /** The best alignments so far: angle, x, y per piece. A copy. */
  partial(): Float64Array {
    return this.#solver.partial();
  }

  /**
   * A share of the search at work, to be run on another thread, and its number; null when there is none. What goes
   * wrong is told when the solver is next advanced.
   */
  lend(): LentShare | null {
    return this.#solver.lend();
  }

  /** What came of a share that was lent; as above. */
  take(number: number, answers: Float64Array): void {
    this.#solver.take(number, answers);
  }

  /** The garment as it was meshed. */
  pattern(): MeshedPattern {
    const text = this.#solver.pattern();
    this.#check();
    return JSON.parse(text) as MeshedPattern;
  }

  /** The result, once `advance` has returned false. */
  result(): SolveResult {
    const started = performance.now();
    const text = this.#solver.result();
    this.#check();
    this.#around += performance.now() - started;
    const result = JSON.parse(text) as SolveResult;
    return {...result, metrics: {...result.metrics, milliseconds: this.milliseconds}};
  }

  /** Time spent computing so far, in whole milliseconds. */
  get milliseconds(): Milliseconds {
    const {alignment, deformation} = this.#spent;
    return {
      alignment: Math.round(alignment),
      deformation: Math.round(deformation),
      total: Math.round(this.#around + alignment + deformation),
    };
  }

  /** Frees the solver's memory; it cannot be used afterwards. */
  [Symbol.dispose](): void {
    this.#solver.delete();
  }

  #check(): void {
    const failure = this.#solver.failure();
    if (failure) throw toError(failure);
  }
}

/** The symmetries a garment shows by itself, as JSON text. @throws {SolverError} */
export function detectSymmetries(module: SeamwiseModule, garment: string, name: string): string {
  return textOf(module.detectSymmetries(garment, name));
}

/** How well a garment mirrors as asked for: both as JSON texts, each with its name. @throws {SolverError} */
export function measureSymmetries(
  module: SeamwiseModule,
  garment: string,
  name: string,
  symmetries: string,
  symmetryName: string,
): string {
  return textOf(module.measureSymmetries(garment, name, symmetries, symmetryName));
}

/** The garment in the project's own format, as JSON text. @throws {SolverError} */
export function convertGarment(module: SeamwiseModule, garment: string, name: string): string {
  return textOf(module.convertGarment(garment, name));
}

function textOf({text, failure}: ModuleText): string {
  if (failure) throw toError(failure);
  return text;
}

export function toError({code, message, piece, seam, reason}: ModuleFailure): SolverError {
  const why = symmetryReasons.find((known) => known === reason);
  return new SolverError({
    code: failureCode(code),
    message,
    piece: piece < 0 ? null : piece,
    seam: seam < 0 ? null : seam,
    ...(why && {reason: why}),
  });
}
