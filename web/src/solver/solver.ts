/// <reference lib="esnext.disposable" preserve="true" />
import {symmetryReasons} from '../model/notes.js';
import {failureCode, SolverError} from '../model/failure.js';
import type {GarmentDocument} from '../model/garment-document.js';
import type {Phase} from '../model/problem.js';
import type {MeshedPattern, Milliseconds, Proof, SolveResult} from '../model/result.js';
import type {DetectedSymmetries, MeasuredSymmetry} from '../model/symmetries.js';
import {documentBytes, documentValue} from './json/document.js';
import {garmentText} from './json/garment-text.js';
import {namedSymmetries, plainNames, type MirrorTexts, type ProblemTexts} from './texts.js';
import type {
  LentShare,
  ModuleDetection,
  ModuleDocument,
  ModuleFailure,
  ModuleProblem,
  ModuleSolver,
  SeamwiseModule,
} from './module/seamwise.mjs';

/**
 * A solve that is advanced slice by slice, from reading its problem on. It owns memory of the module: dispose of it, whatever
 * happens. Methods may throw a SolverError.
 */
export class Solver implements Disposable {
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
    const until = performance.now() + milliseconds;
    let more = true;
    while (more && performance.now() < until) {
      more = this.#solver.prove(1);
      this.#check();
    }
    return more;
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
  [Symbol.dispose](): void {
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

/** A search for the symmetries a garment shows by itself, slice by slice. It owns memory of the module, too. */
export class Detection implements Disposable {
  readonly #detection: ModuleDetection;

  /** @param garment JSON text */
  constructor(module: SeamwiseModule, garment: string, name: string) {
    this.#detection = new module.Detection(documentBytes(garment, module), name);
  }

  /** Works for about `milliseconds`; false when there is nothing left to do. */
  advance(milliseconds: number): boolean {
    const end = performance.now() + milliseconds;
    let more = true;
    while (more && performance.now() < end) more = this.#detection.advance(1);
    return more;
  }

  /** What was found, once `advance` has returned false. @throws {SolverError} for bad input */
  result(): DetectedSymmetries {
    return valueOf(this.#detection.result()) as DetectedSymmetries;
  }

  [Symbol.dispose](): void {
    this.#detection.delete();
  }
}

/** One symmetry, measured on the garment whether or not it mirrors. @throws {SolverError} */
export function measureSymmetry(
  module: SeamwiseModule,
  {garment, name, symmetries}: MirrorTexts,
): MeasuredSymmetry {
  const measured = module.measureSymmetries(
    documentBytes(garment, module),
    name,
    documentBytes(symmetries, module),
    plainNames.symmetry,
  );
  return (valueOf(measured) as {symmetries: [MeasuredSymmetry]}).symmetries[0];
}

/** The garment as everybody but the solver looks at it. @param garment JSON text @throws {SolverError} */
export function garmentDocument(
  module: SeamwiseModule,
  garment: string,
  name: string,
): GarmentDocument {
  return valueOf(module.garment(documentBytes(garment, module), name)) as GarmentDocument;
}

/** The garment in the project's own format. @param garment JSON text @throws {SolverError} */
export function convertGarment(module: SeamwiseModule, garment: string, name: string): string {
  garmentDocument(module, garment, name);
  return garmentText(garment);
}

function valueOf({document, failure}: ModuleDocument): unknown {
  if (failure) throw toError(failure);
  return documentValue(document);
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
