/** What all WebAssembly modules have in common, as Embind shows them. */

/** What lives on a module's heap until `delete()`. */
export interface EmbindObject {
  delete(): void;
}

/** What could not be done; piece and seam are -1 when none is to blame. */
export interface ModuleFailure {
  readonly code: number;
  readonly message: string;
  readonly piece: number;
  readonly seam: number;
  /** Why a symmetry cannot hold, as the code of a note; otherwise empty. */
  readonly reason: string;
}

/** What documents a module takes. */
export interface DocumentLimits {
  /** The largest text that is read. [bytes] */
  readonly maxFileBytes: number;
  /** The most values of one document. */
  readonly maxValues: number;
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
