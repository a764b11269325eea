/**
 * The module that reads prints off pictures as Embind shows it. Everything of type EmbindObject lives on the module's heap until
 * `delete()`; nothing outside this folder's neighbours should have to know that. Places are in pixels of the upright picture, lengths
 * in cm, maps ten numbers: a homography row by row, and the lens.
 */
import type {EmbindObject, ModuleFailure, ModuleSettings} from './module.js';

export interface ModulePhotoRequest {
  readonly width: number;
  readonly height: number;
  /** Red, green, blue, opacity, row by row from the top. */
  readonly pixels: Uint8Array;
  /** Focal length, as on film of 36 mm; NaN where nobody knows. */
  readonly f35: number;
  /** The picture is seamless: one cell, or several. */
  readonly isTile: boolean;
  /** A seamless picture is read whether its edges meet or not. */
  readonly anyEdges: boolean;
  /** Lengths of w1 and w2; NaN where nobody knows. */
  readonly w1Cm: number;
  readonly w2Cm: number;
  /** x, y, x, y, cm: two points and how far they lie apart on the cloth; empty where nobody knows. */
  readonly between: Float64Array;
  /** A map to begin with, to be mended unless `keepsLattice`; empty to look for one. */
  readonly lattice: Float64Array;
  readonly keepsLattice: boolean;
  /** Share of the light's unevenness that is taken away. */
  readonly flatten: number;
}

export interface ModulePhotoGroup {
  readonly name: string;
  readonly rho: number;
  readonly worst: number;
  readonly verdict: string;
  readonly map: Float64Array;
}

/** From, to, ...: stretches of the right edge (`across`, `halfDrop`) or the lower one that do not meet the next copy; shares of it. */
export interface ModuleTileSeams {
  readonly across: Float64Array;
  readonly up: Float64Array;
  readonly halfDrop: Float64Array;
  readonly brick: Float64Array;
}

export interface ModulePhotoReport {
  readonly group: string;
  readonly groups: readonly ModulePhotoGroup[];
  /** w1x, w1y, w2x, w2y as prints have them; |w1| is 1 unless `isScaled`. */
  readonly vectors: Float64Array;
  readonly isScaled: boolean;
  readonly seenAspect: number;
  readonly seenError: number;
  readonly confidence: string;
  readonly uncertainty: number;
  readonly oneWay: boolean;
  readonly stripes: boolean;
  readonly copies: number;
  readonly explained: number;
  /** Maps of other lattices, ten numbers each. */
  readonly others: Float64Array;
  /** Rectangles where copies differ: x, y of the upper left corner, x, y of the lower right one. */
  readonly differing: Float64Array;
  readonly notes: readonly string[];
  readonly seams: ModuleTileSeams;
}

/** What goes on with a picture, step by step. */
export interface ModulePictureWork<Answer> extends EmbindObject {
  failure(): ModuleFailure | null;
  /** One step of some milliseconds; false when nothing is left to do. */
  advance(): boolean;
  stage(): string;
  fraction(): number;
  /** Once done. */
  answer(): Answer;
}

export interface ModulePhotoTileRequest {
  readonly width: number;
  readonly height: number;
  readonly pixels: Uint8Array;
  readonly map: Float64Array;
  readonly isTile: boolean;
  /** A group whose symmetries are made exact; empty for none. */
  readonly group: string;
  readonly flatten: number;
  /** w1x, w1y, w2x, w2y in proportion. */
  readonly vectors: Float64Array;
}

export interface ModuleTile {
  /** Along w1, and along w2, which is up. */
  readonly width: number;
  readonly height: number;
  readonly pixels: Uint8Array;
}

export interface ModuleObjectRequest {
  readonly width: number;
  readonly height: number;
  readonly pixels: Uint8Array;
  readonly map: Float64Array;
  /** w1x, w1y, w2x, w2y in proportion. */
  readonly vectors: Float64Array;
  /** One of those that the core knows. */
  readonly object: string;
  /** x, y of a place on it, near its middle. */
  readonly at: Float64Array;
}

export interface ModuleObject {
  /** A polygon, flat. */
  readonly outline: Float64Array;
  /** x, y, x, y, cm: the ends of its width. */
  readonly between: Float64Array;
  /** Standard error of a length by it, as a share. */
  readonly error: number;
}

export interface PhotoModule {
  photo(request: ModulePhotoRequest): ModulePictureWork<ModulePhotoReport>;
  photoTile(request: ModulePhotoTileRequest): ModulePictureWork<ModuleTile>;
  photoObject(request: ModuleObjectRequest): ModulePictureWork<ModuleObject>;
}

export default function createPhoto(settings?: ModuleSettings): Promise<PhotoModule>;
