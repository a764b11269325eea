/**
 * A print read off a photograph or scan of its cloth. Pixels are those of the upright picture: x to the right, y down,
 * pixel (x, y) between (x, y) and (x + 1, y + 1). Lattice coordinates (u, v) are those of u w1 + v w2.
 */
import type {Point} from './geometry.js';
import type {GroupName} from './print.js';

/** Upright pixels: red, green, blue, opacity, a byte each, row by row from the top. */
export interface PhotoPixels {
  readonly width: number;
  readonly height: number;
  readonly data: Uint8Array | Uint8ClampedArray;
}

/** Row by row: (u, v, 1) to pixels, up to a factor. */
export type Homography = readonly [
  ...(readonly [number, number, number]),
  ...(readonly [number, number, number]),
  ...(readonly [number, number, number]),
];

/** x = lens(H (u, v, 1)): lens(y) = c + (1 + k |y - c|^2 / r^2) (y - c), c the picture's middle, r half its longer side. */
export interface PhotoMap {
  readonly homography: Homography;
  readonly lens: number;
}

/** What somebody knows of a photograph beside its pixels. */
export interface PhotoSettings {
  /** Focal length of the camera, as on film of 36 mm. */
  readonly f35?: number;
  /** The picture is seamless: one cell of the print, or several. */
  readonly isTile?: boolean;
  /** A seamless picture is read whether its edges meet or not; the reading says whether they do. */
  readonly anyEdges?: boolean;
  /** So many repeats along a vector of the lattice measure so many cm. */
  readonly w1Measured?: RepeatsMeasured;
  readonly w2Measured?: RepeatsMeasured;
  /** Two points of the picture that lie so far apart on the cloth. */
  readonly between?: PointsMeasured;
  /** Where the cells lie, as far as somebody knows; it is mended unless `keepsLattice`. */
  readonly lattice?: PhotoMap;
  readonly keepsLattice?: boolean;
  /** How much of the light's unevenness is taken away, 0 to 1; 1 unless said otherwise. */
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
/** `cannot`: no lattice of that shape has the group. */
export type SymmetryVerdict = (typeof symmetryVerdicts)[number];

export const photoConfidences = ['sure', 'likely', 'uncertain'] as const;
export type PhotoConfidence = (typeof photoConfidences)[number];

/** What one of the groups would be on the print that was read. */
export interface PhotoGroup {
  readonly name: GroupName;
  /** Share of the pattern's energy that breaks it; and the greatest such share at one place. */
  readonly rho: number;
  readonly worst: number;
  readonly verdict: SymmetryVerdict;
  /** Where its cells lie: its w1, w2 and its origin. */
  readonly map: PhotoMap;
}

export const photoStages = ['repeat', 'light', 'symmetry', 'tile', 'object'] as const;
export type PhotoStage = (typeof photoStages)[number];

export interface PhotoProgress {
  readonly stage: PhotoStage;
  /** Of the whole, 0 to 1. */
  readonly fraction: number;
}

export interface PhotoHooks {
  readonly signal?: AbortSignal;
  readonly onProgress?: (progress: PhotoProgress) => void;
}

/**
 * `uneven`: creases move the print by more than cloth does that lies flat; `differs`: parts of the picture differ from all other
 * copies; `focalLength`: proportions are known no better than the camera is; `unequal`: sides that the print's symmetry has equal
 * measure differently, so that a smaller one was taken.
 */
export const photoNotes = ['uneven', 'differs', 'focalLength', 'unequal'] as const;
export type PhotoNote = (typeof photoNotes)[number];

/** Why no print can be read off a picture; `object`: no coin or card is seen where somebody says; `misplaced`: it does not repeat by the cell that was given. */
export const photoFaults = [
  ...(['plain', 'noRepeat', 'fewRepeats', 'twoPrints', 'changes'] as const),
  ...(['blurred', 'moire', 'uneven', 'edges', 'small', 'object', 'misplaced'] as const),
] as const;
export type PhotoFault = (typeof photoFaults)[number];

export type Side = 'left' | 'right' | 'top' | 'bottom';

/** A part of a side at which a picture breaks off; shares of that side, from its left or upper end. */
export interface OpenEdge {
  readonly side: Side;
  readonly from: number;
  readonly to: number;
}

/** Where a seamless picture does not meet its copies, repeated in each way. */
export interface TileSeams {
  readonly straight: readonly OpenEdge[];
  readonly halfDrop: readonly OpenEdge[];
  readonly brick: readonly OpenEdge[];
}

export interface PhotoReading {
  readonly width: number;
  readonly height: number;
  /** Of the group that it has. */
  readonly map: PhotoMap;
  /** The map's vectors and origin at the picture's middle. */
  readonly w1Px: Point;
  readonly w2Px: Point;
  readonly originPx: Point;
  /** As the print has them, +y along the warp; null until a length is known. [cm] */
  readonly w1: Point | null;
  readonly w2: Point | null;
  /** The same, longer or shorter by a factor that nobody knows: |w1| is 1. */
  readonly shape: readonly [Point, Point];
  /** |w2| / |w1| as the picture alone shows it, whatever was measured, and the share by which it may err. */
  readonly seen: {readonly aspect: number; readonly error: number};
  readonly group: GroupName;
  /** All 17, in their usual order. */
  readonly groups: readonly PhotoGroup[];
  readonly confidence: PhotoConfidence;
  /** Standard error of the lengths of w1 and w2, as a share. */
  readonly latticeUncertainty: number;
  readonly oneWay: boolean;
  readonly stripes: boolean;
  /** Cells that are seen whole. */
  readonly copies: number;
  /** Share of the picture's variance that the other copies foretell. */
  readonly explained: number;
  /** Other lattices that it may be, where that is uncertain. */
  readonly others: readonly PhotoMap[];
  /** Of the picture, where copies differ: creases, dirt. */
  readonly differing: readonly (readonly Point[])[];
  /** What somebody should know. */
  readonly notes: readonly PhotoNote[];
  /** Of a seamless picture that was read with any edges. */
  readonly seams?: TileSeams;
}

/** The length of one repeat. [cm] */
export const oneRepeat = (measured: RepeatsMeasured | undefined): number | undefined =>
  measured && measured.cm / measured.repeats;

/** The share by which w2 is longer or shorter than is to be expected of w1. @param aspect |w2| / |w1| */
export const shareApart = (w1: number, w2: number, aspect: number): number =>
  Math.abs(w2 / (w1 * aspect) - 1);

/** A clean picture of the print's cell, as prints have it. */
export interface PhotoTileSettings {
  readonly map: PhotoMap;
  readonly isTile?: boolean;
  /** Symmetries that are made exact; none, unless said otherwise. */
  readonly symmetrise?: GroupName;
  readonly flatten?: number;
  /** Of w1 and w2, in proportion. */
  readonly shape: readonly [Point, Point];
  /** Factors of red, green and blue light, in which what is white is white; 1 unless said otherwise. */
  readonly gains?: ColourGains;
}

export type ColourGains = readonly [number, number, number];

/** By their mints, ISO/IEC 7810 ID-1, and ISO 216. */
export const knownObjects = ['eur1', 'eur2', 'quarter', 'gbp1', 'card', 'a4'] as const;
export type KnownObject = (typeof knownObjects)[number];

/** A thing of known size that lies flat on the cloth. */
export interface PhotoObjectSettings {
  readonly object: KnownObject;
  /** A place on it, near its middle. [px] */
  readonly at: Point;
  readonly map: PhotoMap;
  /** Of w1 and w2, in proportion. */
  readonly shape: readonly [Point, Point];
}

export interface PhotoObject {
  readonly object: KnownObject;
  readonly outline: readonly Point[];
  /** The ends of its width. */
  readonly between: PointsMeasured;
  /** Standard error of a length by it, as a share. */
  readonly error: number;
}

export interface PhotoObjectRequest extends PhotoObjectSettings {
  /** A file is decoded by who answers. */
  readonly picture: PhotoPixels | Blob;
}

export interface PhotoRequest extends PhotoSettings {
  /** A file is decoded by who answers. */
  readonly picture: PhotoPixels | Blob;
}

export interface PhotoTileRequest extends PhotoTileSettings {
  readonly picture: PhotoPixels | Blob;
}
