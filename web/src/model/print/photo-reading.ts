/**
 * A print read from a photo or scan of its fabric. Pixels are those of the upright image: x to the
 * right, y down, pixel (x, y) between (x, y) and (x + 1, y + 1). Lattice coordinates (u, v) mean u
 * w1 + v w2.
 */
import type {Point} from '../geometry/vectors.js';
import type {GroupName} from './repeating-print.js';

/** Upright pixels: red, green, blue, opacity, a byte each, row by row from the top. */
export interface PhotoPixels {
  readonly width: number;
  readonly height: number;
  readonly data: Uint8Array | Uint8ClampedArray;
}

/** Matrix from (u, v, 1) to pixels, row by row, up to a factor. */
export type Homography = readonly [
  ...(readonly [number, number, number]),
  ...(readonly [number, number, number]),
  ...(readonly [number, number, number]),
];

/**
 * The map x = lens(H (u, v, 1)), lens(y) = c + (1 + k |y - c|^2 / r^2) (y - c), with c the centre
 * of the image, r half its longer side.
 */
export interface PhotoMap {
  readonly homography: Homography;
  readonly lens: number;
}

/** Known facts about a photo, apart from its pixels. */
export interface PhotoSettings {
  /** Focal length of the camera, equivalent for film 36 mm wide. [mm] */
  readonly f35?: number;
  /** True if the image is seamless: one cell of the print, or several. */
  readonly isTile?: boolean;
  /**
   * True if a seamless image is read even if its edges do not meet; the reading then lists the gaps
   * in `seams`.
   */
  readonly anyEdges?: boolean;
  /** Measured length of a number of repeats along a lattice vector. */
  readonly w1Measured?: RepeatsMeasured;
  readonly w2Measured?: RepeatsMeasured;
  /** Two points of the image, and their distance on the fabric. */
  readonly between?: PointsMeasured;
  /** Estimated lattice; it is refined unless `keepsLattice`. */
  readonly lattice?: PhotoMap;
  readonly keepsLattice?: boolean;
  /** Share of the uneven lighting to remove, 0 to 1. Default 1. */
  readonly flatten?: number;
}

export interface RepeatsMeasured {
  readonly repeats: number;
  readonly cm: number;
}

export interface PointsMeasured {
  readonly from: Point;
  readonly to: Point;
  readonly cm: number;
}

export const symmetryVerdicts = ['has', 'almost', 'has not', 'cannot'] as const;
/** Verdict on a group; `cannot`: no lattice of that shape has it. */
export type SymmetryVerdict = (typeof symmetryVerdicts)[number];

export const photoConfidences = ['sure', 'likely', 'uncertain'] as const;
export type PhotoConfidence = (typeof photoConfidences)[number];

/** Findings about one of the groups on the print. */
export interface PhotoGroup {
  readonly name: GroupName;
  /**
   * Share of the pattern's energy that breaks the group, and the greatest such share at one place.
   */
  readonly rho: number;
  readonly worst: number;
  readonly verdict: SymmetryVerdict;
  /** Map with the group's w1, w2 and origin. */
  readonly map: PhotoMap;
}

export const photoStages = ['repeat', 'light', 'symmetry', 'tile', 'object'] as const;
export type PhotoStage = (typeof photoStages)[number];

export interface PhotoProgress {
  readonly stage: PhotoStage;
  /** Share of the whole, 0 to 1. */
  readonly fraction: number;
}

export interface PhotoHooks {
  readonly signal?: AbortSignal;
  readonly onProgress?: (progress: PhotoProgress) => void;
}

/**
 * `uneven`: creases move the print by more than flat fabric does; `differs`: parts of the image
 * differ from all other copies; `focalLength`: proportions are only as certain as the camera's
 * focal length; `unequal`: sides that are equal by the print's symmetry measure differently, so a
 * smaller group is used.
 */
export const photoNotes = ['uneven', 'differs', 'focalLength', 'unequal'] as const;
export type PhotoNote = (typeof photoNotes)[number];

export type Side = 'left' | 'right' | 'top' | 'bottom';

/**
 * A stretch of a side at which an image does not continue, as shares of the side from its left or
 * upper end.
 */
export interface OpenEdge {
  readonly side: Side;
  readonly from: number;
  readonly to: number;
}

/** Stretches at which a seamless image does not meet its copies, for each way of repeating it. */
export interface TileSeams {
  readonly straight: readonly OpenEdge[];
  readonly halfDrop: readonly OpenEdge[];
  readonly brick: readonly OpenEdge[];
}

export interface PhotoReading {
  readonly width: number;
  readonly height: number;
  /** Map of the print's group. */
  readonly map: PhotoMap;
  /** Vectors and origin of the map at the centre of the image. */
  readonly w1Px: Point;
  readonly w2Px: Point;
  readonly originPx: Point;
  /** Vectors of the print, +y along the warp; null until a length is known. [cm] */
  readonly w1: Point | null;
  readonly w2: Point | null;
  /** The same vectors up to an unknown factor: |w1| is 1. */
  readonly shape: readonly [Point, Point];
  /** |w2| / |w1| according to the image alone, without measurements, and its relative error. */
  readonly seen: {readonly aspect: number; readonly error: number};
  readonly group: GroupName;
  /** All 17 groups, in their usual order. */
  readonly groups: readonly PhotoGroup[];
  readonly confidence: PhotoConfidence;
  /** Relative standard error of the lengths of w1 and w2. */
  readonly latticeUncertainty: number;
  readonly oneWay: boolean;
  readonly stripes: boolean;
  /** Number of cells that are completely visible. */
  readonly copies: number;
  /** Share of the image's variance that the other copies predict. */
  readonly explained: number;
  /** Other possible lattices, if the lattice is uncertain. */
  readonly others: readonly PhotoMap[];
  /** Areas of the image where copies differ: creases, dirt. */
  readonly differing: readonly (readonly Point[])[];
  /** Notes for the user. */
  readonly notes: readonly PhotoNote[];
  /** Gaps of a seamless image that was read with `anyEdges`. */
  readonly seams?: TileSeams;
}

/** Length of one repeat. [cm] */
export const oneRepeat = (measured: RepeatsMeasured | undefined): number | undefined =>
  measured && measured.cm / measured.repeats;

/** Relative deviation of w2 from the length expected for w1. @param aspect |w2| / |w1| */
export const shareApart = (w1: number, w2: number, aspect: number): number =>
  Math.abs(w2 / (w1 * aspect) - 1);

/** Settings for a clean image of the print's cell in the form that prints have. */
export interface PhotoTileSettings {
  readonly map: PhotoMap;
  readonly isTile?: boolean;
  /** Group whose symmetries are made exact. Default: none. */
  readonly symmetrise?: GroupName;
  readonly flatten?: number;
  /** Vectors w1 and w2, in proportion. */
  readonly shape: readonly [Point, Point];
  /** Factors of red, green and blue light that turn white objects white. Default 1. */
  readonly gains?: ColourGains;
}

export type ColourGains = readonly [number, number, number];

/** Objects of known size, according to their mints, ISO/IEC 7810 ID-1, and ISO 216. */
export const knownObjects = ['eur1', 'eur2', 'quarter', 'gbp1', 'card', 'a4'] as const;
export type KnownObject = (typeof knownObjects)[number];

/** An object of known size that is flat on the fabric. */
export interface PhotoObjectSettings {
  readonly object: KnownObject;
  /** A point of the object, near its centre. [px] */
  readonly at: Point;
  readonly map: PhotoMap;
  /** Vectors w1 and w2, in proportion. */
  readonly shape: readonly [Point, Point];
}

export interface PhotoObject {
  readonly object: KnownObject;
  readonly outline: readonly Point[];
  /** Ends of the object's width. */
  readonly between: PointsMeasured;
  /** Relative standard error of a length measured with the object. */
  readonly error: number;
}

export interface PhotoObjectRequest extends PhotoObjectSettings {
  /** Pixels, or a file that the solver's thread decodes. */
  readonly picture: PhotoPixels | Blob;
}

export interface PhotoRequest extends PhotoSettings {
  /** Pixels, or a file that the solver's thread decodes. */
  readonly picture: PhotoPixels | Blob;
}

export interface PhotoTileRequest extends PhotoTileSettings {
  readonly picture: PhotoPixels | Blob;
}
