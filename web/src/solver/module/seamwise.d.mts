/**
 * The WebAssembly module as Embind shows it. Everything of type EmbindObject lives on the module's
 * heap until `delete()`; nothing outside this folder's neighbours should have to know that.
 */

import type {DocumentLimits, EmbindObject, ModuleFailure, ModuleSettings} from './module.js';

/** Documents of the problem's files, and the names to call them by in messages. */
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

/** A solve that is advanced step by step, reading included. After any call, `failure()` says whether it went wrong. */
export interface ModuleSolver extends EmbindObject {
  failure(): ModuleFailure | null;
  /** Runs some steps; false when there is nothing left to do. */
  advance(steps: number): boolean;
  phase(): 'preparation' | 'alignment' | 'deformation';
  /** Grows when the deformation starts over; the time of earlier attempts does not count. */
  attempt(): number;
  fraction(): number;
  /** Angle, x, y per piece; a copy. Empty during the preparation. */
  partial(): Float64Array;
  /** A share of the present search, for `Share` in another thread; null when there is none. */
  lend(): LentShare | null;
  /** Whether a share, by its number, is still to be had by nobody else. */
  awaits(number: number): boolean;
  /** The answers of a share; ignored when the search has ended. */
  take(number: number, answers: Float64Array): void;
  /** The garment as it was meshed, a document; empty during the preparation and after a failure. */
  pattern(): Uint8Array<ArrayBuffer>;
  /** The result, a document; empty after a failure. */
  result(): Uint8Array<ArrayBuffer>;
  /** Once it is prepared: proves how good alignments can be; false when no more can be proven. */
  prove(steps: number): boolean;
  proven(): ModuleProof;
}

/** How good alignments of the pieces as drafted can be. */
export interface ModuleProof {
  /** None costs less than this share of the best one found: 1 when that is proven the best. */
  readonly bound: number;
  /** Of the best one found, as in the result's metrics. [cm2] */
  readonly searchCost: number;
}

/** All that a share depends on, as numbers that only this build of the module can read; a copy. */
export interface LentShare {
  readonly number: number;
  readonly order: Float64Array;
}

/** A share of another thread's search. */
export interface ModuleShare extends EmbindObject {
  failure(): ModuleFailure | null;
  /** Runs some steps; false when there is nothing left to do. */
  advance(steps: number): boolean;
  /** Once there is not: for `take`; a copy. */
  answers(): Float64Array;
}

/** Looks step by step for the symmetries a garment shows by itself. */
export interface ModuleDetection extends EmbindObject {
  /** Runs some steps; false when there is nothing left to do. */
  advance(steps: number): boolean;
  /** What was found, once `advance` has returned false. */
  result(): ModuleDocument;
}

/** A document, or why there is none. */
export interface ModuleDocument {
  readonly document: Uint8Array<ArrayBuffer>;
  readonly failure: ModuleFailure | null;
}

/** Documents are JSON as `../json/document.ts` writes and reads it. */
export interface SeamwiseModule extends DocumentLimits {
  readonly Solver: new (problem: ModuleProblem) => ModuleSolver;
  readonly Share: new (order: Float64Array) => ModuleShare;
  readonly Detection: new (garment: Uint8Array, name: string) => ModuleDetection;
  /** How well the garment mirrors as the symmetries ask. */
  measureSymmetries(
    garment: Uint8Array,
    name: string,
    symmetries: Uint8Array,
    symmetryName: string,
  ): ModuleDocument;
  /** Why a garment cannot be read. */
  garment(garment: Uint8Array, name: string): ModuleDocument;
  /** Size of the module's memory. [bytes] */
  heapBytes(): number;
  /** Of that, what is in use. [bytes] */
  liveBytes(): number;
}

declare const createSeamwise: (settings?: ModuleSettings) => Promise<SeamwiseModule>;
export default createSeamwise;
