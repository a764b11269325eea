/**
 * The module that drapes as Embind shows it. Everything of type EmbindObject lives on the module's heap until
 * `delete()`; nothing outside this folder's neighbours should have to know that.
 */
import type {DrapeMesh, Drape, DrapeStage, Form} from '../../model/drape.js';
import type {DocumentLimits, EmbindObject, ModuleFailure, ModuleSettings} from './module.js';

/** Documents, and the names to call them by in messages. */
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
  /** As `positions()` of an earlier drape; empty without one. */
  readonly settled: Float64Array;
}

/** A drape that is advanced step by step, reading included. After any call, `failure()` says whether it went wrong. */
export interface ModuleDrape extends EmbindObject {
  failure(): ModuleFailure | null;
  /** Goes on until about so much work is spent; the first call reads, meshes and hangs. False when there is nothing left to do. */
  advance(work: number): boolean;
  /** Empty before the first call of `advance`. */
  stage(): DrapeStage | '';
  /** 0 to 1 */
  fraction(): number;
  form(): Form;
  /** Changes when `stage()` becomes `settle`. */
  mesh(): DrapeMesh;
  /** x, y, z per vertex of the cloth; copies. [cm] */
  shown(): Float32Array;
  positions(): Float64Array;
  /** Once `advance` has returned false. */
  report(): Pick<Drape, 'fabric' | 'stages' | 'check' | 'notes'>;
}

export interface DrapeModule extends DocumentLimits {
  readonly Drape: new (request: ModuleDrapeRequest) => ModuleDrape;
}

declare const createDrape: (settings?: ModuleSettings) => Promise<DrapeModule>;
export default createDrape;
