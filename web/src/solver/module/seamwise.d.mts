/**
 * The solver module's Embind interface. Every EmbindObject stays on the module's heap until
 * `delete()`; only the code in neighbouring folders should depend on that.
 */

import type {DocumentLimits, EmbindObject, ModuleFailure, ModuleSettings} from './module.js';

/** Documents of the problem's files, and their names in messages. */
export interface ModuleProblem {
  readonly garment: Uint8Array;
  readonly garmentName: string;
  readonly print: Uint8Array;
  readonly printName: string;
  /** `auto`, `none` or a document. */
  readonly symmetry: Uint8Array | string;
  readonly symmetryName: string;
  /** May be empty. */
  readonly options: Uint8Array | '';
  readonly optionsName: string;
  readonly method: string;
  readonly seed: number;
}

/**
 * A solve that is advanced step by step, including reading. After any call, `failure()` returns the
 * failure, if there was one.
 */
export interface ModuleSolver extends EmbindObject {
  failure(): ModuleFailure | null;
  /** Runs some steps; returns false when nothing is left to do. */
  advance(steps: number): boolean;
  phase(): 'preparation' | 'alignment' | 'deformation';
  /** Increases when the deformation starts over; the time of earlier attempts does not count. */
  attempt(): number;
  fraction(): number;
  /** Angle, x, y per piece, as a copy. Empty during the preparation. */
  partial(): Float64Array;
  /** A share of the present search, for `Share` in another thread; null if there is none. */
  lend(): LentShare | null;
  /** Returns whether the answers of a lent share, by its number, are still needed. */
  awaits(number: number): boolean;
  /** Takes the answers of a share; ignored when the search has ended. */
  take(number: number, answers: Float64Array): void;
  /** The meshed garment as a document; empty during the preparation and after a failure. */
  pattern(): Uint8Array<ArrayBuffer>;
  /** The result as a document; empty after a failure. */
  result(): Uint8Array<ArrayBuffer>;
  /**
   * Proves a bound on alignments, after the preparation; returns false when no more can be proven.
   */
  prove(steps: number): boolean;
  proven(): ModuleProof;
}

/** Bound on alignments of the pieces as drafted. */
export interface ModuleProof {
  /**
   * No alignment costs less than this share of the best found one's cost: 1 when that is proven the
   * best.
   */
  readonly bound: number;
  /** Cost of the best found alignment, as in the result's metrics. [cm2] */
  readonly searchCost: number;
}

/** Complete data of a share, as numbers that only this build of the module can read; a copy. */
export interface LentShare {
  readonly number: number;
  readonly order: Float64Array;
}

/** A share of another thread's search. */
export interface ModuleShare extends EmbindObject {
  failure(): ModuleFailure | null;
  /** Runs some steps; returns false when nothing is left to do. */
  advance(steps: number): boolean;
  /** Answers for `take`, available once nothing is left to do; a copy. */
  answers(): Float64Array;
}

/** Detects the symmetries of a garment step by step. */
export interface ModuleDetection extends EmbindObject {
  /** Runs some steps; returns false when nothing is left to do. */
  advance(steps: number): boolean;
  /** The detected symmetries, available once `advance` has returned false. */
  result(): ModuleDocument;
}

/** A document, or the failure that prevented it. */
export interface ModuleDocument {
  readonly document: Uint8Array<ArrayBuffer>;
  readonly failure: ModuleFailure | null;
}

/** Documents are JSON in the format of `../json/document.ts`. */
export interface SeamwiseModule extends DocumentLimits {
  readonly Solver: new (problem: ModuleProblem) => ModuleSolver;
  readonly Share: new (order: Float64Array) => ModuleShare;
  readonly Detection: new (garment: Uint8Array, name: string) => ModuleDetection;
  /** Measures how well the garment mirrors by the given symmetries. */
  measureSymmetries(
    garment: Uint8Array,
    name: string,
    symmetries: Uint8Array,
    symmetryName: string,
  ): ModuleDocument;
  /** Reads a garment: its document, or the reason why it cannot be read. */
  garment(garment: Uint8Array, name: string): ModuleDocument;
  /** Size of the module's memory. [bytes] */
  heapBytes(): number;
  /** Part of the memory that is in use. [bytes] */
  liveBytes(): number;
}

declare const createSeamwise: (settings?: ModuleSettings) => Promise<SeamwiseModule>;
export default createSeamwise;
