/**
 * The drape module's Embind interface. Every EmbindObject stays on the module's heap until
 * `delete()`; only the code in neighbouring folders should depend on that.
 */
import type {DrapeMesh, Drape, DrapeStage, Form} from '../../model/result/draped-garment.js';
import type {DocumentLimits, EmbindObject, ModuleFailure, ModuleSettings} from './module.js';

/** Documents, and their names in messages. */
export interface ModuleDrapeRequest {
  readonly result: Uint8Array;
  readonly resultName: string;
  /** May be empty. */
  readonly body: Uint8Array | '';
  readonly bodyName: string;
  readonly fabric: string;
  /** May be empty. */
  readonly size: string;
  readonly effort: number;
  /** Positions from `positions()` of an earlier drape; empty without one. */
  readonly settled: Float64Array;
}

/**
 * A drape that is advanced step by step, including reading. After any call, `failure()` returns the
 * failure, if there was one.
 */
export interface ModuleDrape extends EmbindObject {
  failure(): ModuleFailure | null;
  /**
   * Continues until about this much work is done. The first call reads, meshes and hangs the
   * garment. Returns false when nothing is left to do.
   */
  advance(work: number): boolean;
  /** Empty before the first call of `advance`. */
  stage(): DrapeStage | '';
  /** Share of the work done, 0 to 1. */
  fraction(): number;
  form(): Form;
  /** Changes when `stage()` becomes `settle`. */
  mesh(): DrapeMesh;
  /** Coordinates x, y, z per vertex of the mesh, as copies. [cm] */
  shown(): Float32Array;
  positions(): Float64Array;
  /** Available once `advance` has returned false. */
  report(): Pick<Drape, 'fabric' | 'stages' | 'check' | 'notes' | 'noteDetails'>;
}

export interface DrapeModule extends DocumentLimits {
  readonly Drape: new (request: ModuleDrapeRequest) => ModuleDrape;
}

declare const createDrape: (settings?: ModuleSettings) => Promise<DrapeModule>;
export default createDrape;
