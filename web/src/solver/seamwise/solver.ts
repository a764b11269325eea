import type {Phase} from '../../model/problem.js';
import type {MeshedPattern, Milliseconds, Proof, SolveResult} from '../../model/result.js';
import {stepsFor} from '../answers/slices.js';
import {documentBytes, documentValue} from '../json/document.js';
import type {LentShare, ModuleProblem, ModuleSolver, SeamwiseModule} from '../module/seamwise.mjs';
import {namedSymmetries, type ProblemTexts} from '../requests/texts.js';
import {toError} from './failures.js';

/**
 * A solve that is advanced slice by slice, from reading its problem on. It owns memory of the module: delete it, whatever
 * happens. Methods may throw a SolverError.
 */
export class Solver {
  readonly #solver: ModuleSolver;
  /** Preparation, and measuring at the end. [ms] */
  #around = 0;
  readonly #spent = {alignment: 0, deformation: 0};
  #attempt = 0;
  /** What the module broke on while shares were passed on. */
  #broken: Error | null = null;

  constructor(module: SeamwiseModule, problem: ProblemTexts) {
    const started = performance.now();
    this.#solver = new module.Solver(problemDocuments(module, problem));
    this.#around += performance.now() - started;
  }

  /**
   * Works for about `milliseconds`, within one phase; false when there is nothing left to do.
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

  /** Only the last attempt at the deformation counts. */
  #count(phase: Phase, milliseconds: number): void {
    if (phase === 'preparation') {
      this.#around += milliseconds;
      return;
    }
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

  /** The best alignments so far, once it is prepared: angle, x, y per piece. A copy. */
  partial(): Float64Array {
    return this.#solver.partial();
  }

  /**
   * A share of the search at work, to be run on another thread, and its number; null when there is none. What goes
   * wrong is told when the solver is next advanced.
   */
  lend(): LentShare | null {
    return this.#unlessBroken(() => this.#solver.lend());
  }

  /** Whether the answers of a share that was lent are still of use. */
  awaits(number: number): boolean {
    return this.#solver.awaits(number);
  }

  /** What came of a share that was lent; as above. */
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

  /** The garment as it was meshed, once it is prepared. */
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

  /** Proves how good alignments can be, for about `milliseconds`; false when no more can be proven. */
  prove(milliseconds: number): boolean {
    return stepsFor(milliseconds, () => {
      const more = this.#solver.prove(1);
      this.#check();
      return more;
    });
  }

  /** What is proven by then. */
  proof(): Proof {
    return this.#solver.proven();
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
