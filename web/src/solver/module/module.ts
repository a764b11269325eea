/** Common parts of the Embind interfaces of all WebAssembly modules. */

/** An object that stays on a module's heap until `delete()`. */
export interface EmbindObject {
  delete(): void;
}

/** A failure; piece and seam are -1 if none is affected. */
export interface ModuleFailure {
  readonly code: number;
  readonly message: string;
  readonly piece: number;
  readonly seam: number;
  /** Reason as a code (`Failure.reason`), or empty. */
  readonly reason: string;
}

/** Limits of a module for documents. */
export interface DocumentLimits {
  /** Size of the largest text that is read. [bytes] */
  readonly maxFileBytes: number;
  /** Greatest number of values in one document. */
  readonly maxValues: number;
}

export interface ModuleSettings {
  /** The .wasm file; without it the module fetches the file beside it. */
  readonly wasmBinary?: ArrayBufferView | ArrayBuffer;
  /** Returns the URL of a file of the module. */
  readonly locateFile?: (file: string, folder: string) => string;
  /** Passes the instance on when it is ready. */
  readonly instantiateWasm?: (
    imports: WebAssembly.Imports,
    receive: (instance: WebAssembly.Instance) => void,
  ) => object;
}
