/**
 * The WebAssembly module as Embind shows it. Everything of type EmbindObject lives on the module's
 * heap until `delete()`; nothing outside this folder's neighbours should have to know that.
 */

/** What could not be done; piece and seam are -1 when none is to blame. */
export interface ModuleFailure {
  readonly code: number;
  readonly message: string;
  readonly piece: number;
  readonly seam: number;
  /** Why a symmetry cannot hold, as the code of a note; otherwise empty. */
  readonly reason: string;
}

/** Texts of the problem's files, and the names to call them by in messages. */
export interface ModuleProblem {
  readonly garment: string;
  readonly garmentName: string;
  readonly print: string;
  readonly printName: string;
  /** `auto`, `none` or JSON. */
  readonly symmetry: string;
  readonly symmetryName: string;
  /** JSON, or empty. */
  readonly options: string;
  readonly optionsName: string;
  readonly method: string;
  readonly seed: number;
}

export interface EmbindObject {
  delete(): void;
}

/** A solve that is advanced step by step. After any call, `failure()` says whether it went wrong. */
export interface ModuleSolver extends EmbindObject {
  failure(): ModuleFailure | null;
  /** Runs some steps; false when there is nothing left to do. */
  advance(steps: number): boolean;
  phase(): 'alignment' | 'deformation';
  /** Grows when the deformation starts over; the time of earlier attempts does not count. */
  attempt(): number;
  fraction(): number;
  /** Angle, x, y per piece; a copy. */
  partial(): Float64Array;
  /** A share of the present search, for `Share` in another thread; null when there is none. */
  lend(): LentShare | null;
  /** The answers of a share by its number; ignored when the search has ended. */
  take(number: number, answers: Float64Array): void;
  /** The garment as it was meshed, as JSON; empty after a failure. */
  pattern(): string;
  /** The result as JSON; empty after a failure. */
  result(): string;
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

/** A text, or why there is none. */
export interface ModuleText {
  readonly text: string;
  readonly failure: ModuleFailure | null;
}

export interface SeamwiseModule {
  readonly Solver: new (problem: ModuleProblem) => ModuleSolver;
  readonly Share: new (order: Float64Array) => ModuleShare;
  /** Symmetries the garment shows by itself, as JSON. */
  detectSymmetries(garment: string, name: string): ModuleText;
  /** How well the garment mirrors as the symmetries ask, as JSON. */
  measureSymmetries(
    garment: string,
    name: string,
    symmetries: string,
    symmetryName: string,
  ): ModuleText;
  /** The garment as seamwise-garment/1. */
  convertGarment(garment: string, name: string): ModuleText;
  /** Size of the module's memory. [bytes] */
  heapBytes(): number;
  /** Of that, what is in use. [bytes] */
  liveBytes(): number;
}

export interface ModuleSettings {
  /** The .wasm file; without it the module fetches its neighbour. */
  readonly wasmBinary?: ArrayBufferView | ArrayBuffer;
  /** Where to find a file of the module. */
  readonly locateFile?: (file: string, folder: string) => string;
  /** Hands over the instance when it has been made. */
  readonly instantiateWasm?: (
    imports: WebAssembly.Imports,
    receive: (instance: WebAssembly.Instance) => void,
  ) => object;
}

declare const createSeamwise: (settings?: ModuleSettings) => Promise<SeamwiseModule>;
export default createSeamwise;
