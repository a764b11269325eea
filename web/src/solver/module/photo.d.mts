/**
 * The photo module's Embind interface. Every EmbindObject stays on the module's heap until
 * `delete()`; only the code in neighbouring folders should depend on that. Places are in pixels of
 * the upright image, lengths in cm. A map is ten numbers: a homography row by row, and the lens.
 */
import type {EmbindObject, ModuleFailure, ModuleSettings} from './module.js';

export interface ModulePhotoRequest {
  readonly width: number;
  readonly height: number;
  /** Red, green, blue, opacity, row by row from the top. */
  readonly pixels: Uint8Array;
  /** Focal length, equivalent for film 36 mm wide; NaN if unknown. [mm] */
  readonly f35: number;
  /** True if the image is seamless: one cell, or several. */
  readonly isTile: boolean;
  /** True if a seamless image is read even if its edges do not meet. */
  readonly anyEdges: boolean;
  /** Lengths of w1 and w2; NaN if unknown. */
  readonly w1Cm: number;
  readonly w2Cm: number;
  /** Two points and their distance on the fabric: x, y, x, y, cm; empty if unknown. */
  readonly between: Float64Array;
  /** Map to begin with, which is refined unless `keepsLattice`; empty to search for one. */
  readonly lattice: Float64Array;
  readonly keepsLattice: boolean;
  /** Share of the uneven lighting to remove. */
  readonly flatten: number;
}

export interface ModulePhotoGroup {
  readonly name: string;
  readonly rho: number;
  readonly worst: number;
  readonly verdict: string;
  readonly map: Float64Array;
}

/**
 * Stretches of the right edge (`across`, `halfDrop`) or the lower edge that do not meet the next
 * copy: from, to, ... as shares of the edge.
 */
export interface ModuleTileSeams {
  readonly across: Float64Array;
  readonly up: Float64Array;
  readonly halfDrop: Float64Array;
  readonly brick: Float64Array;
}

export interface ModulePhotoReport {
  readonly group: string;
  readonly groups: readonly ModulePhotoGroup[];
  /** Vectors of the print: w1x, w1y, w2x, w2y; |w1| is 1 unless `isScaled`. */
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
  /**
   * Rectangles in which copies differ: x, y of the upper left corner, x, y of the lower right one.
   */
  readonly differing: Float64Array;
  readonly notes: readonly string[];
  readonly seams: ModuleTileSeams;
}

/** Work on an image, step by step. */
export interface ModulePictureWork<Answer> extends EmbindObject {
  failure(): ModuleFailure | null;
  /** Takes one step of some milliseconds; returns false when nothing is left to do. */
  advance(): boolean;
  stage(): string;
  fraction(): number;
  /** Available once the work is done. */
  answer(): Answer;
}

export interface ModulePhotoTileRequest {
  readonly width: number;
  readonly height: number;
  readonly pixels: Uint8Array;
  readonly map: Float64Array;
  readonly isTile: boolean;
  /** Group whose symmetries are made exact; empty for none. */
  readonly group: string;
  readonly flatten: number;
  /** Vectors w1x, w1y, w2x, w2y in proportion. */
  readonly vectors: Float64Array;
}

export interface ModuleTile {
  /** Size along w1, and along w2, which points up. [px] */
  readonly width: number;
  readonly height: number;
  readonly pixels: Uint8Array;
}

export interface ModuleObjectRequest {
  readonly width: number;
  readonly height: number;
  readonly pixels: Uint8Array;
  readonly map: Float64Array;
  /** Vectors w1x, w1y, w2x, w2y in proportion. */
  readonly vectors: Float64Array;
  /** Name of an object that the core knows. */
  readonly object: string;
  /** A point of the object, near its centre: x, y. */
  readonly at: Float64Array;
}

export interface ModuleObject {
  /** Polygon of flat x, y pairs. */
  readonly outline: Float64Array;
  /** Ends of the object's width, and the width: x, y, x, y, cm. */
  readonly between: Float64Array;
  /** Relative standard error of a length measured with the object. */
  readonly error: number;
}

export interface PhotoModule {
  photo(request: ModulePhotoRequest): ModulePictureWork<ModulePhotoReport>;
  photoTile(request: ModulePhotoTileRequest): ModulePictureWork<ModuleTile>;
  photoObject(request: ModuleObjectRequest): ModulePictureWork<ModuleObject>;
}

export default function createPhoto(settings?: ModuleSettings): Promise<PhotoModule>;
