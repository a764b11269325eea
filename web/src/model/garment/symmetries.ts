import type {MirrorMap, Point} from '../geometry/vectors.js';

/** A piece that mirrors onto itself: by an axis, by two outline edges, or by a detected axis. */
export interface PieceSymmetry {
  readonly kind: 'piece';
  readonly piece: string;
  /** Two points of the axis in the coordinates of the input panel. [cm] */
  readonly axis?: readonly [Point, Point];
  /** Two outline edges, by their number in the file, that mirror onto each other. */
  readonly seams?: readonly [number, number];
}

/** Two pieces that mirror onto each other. */
export interface PairSymmetry {
  readonly kind: 'pair';
  readonly pieces: readonly [string, string];
}

export type Symmetry = PieceSymmetry | PairSymmetry;

export interface Symmetries {
  readonly symmetries: readonly Symmetry[];
}

/** Map of a symmetry on the garment, and its accuracy. Requests do not need it. */
export interface Registration {
  /** Greatest distance of an outline from its mirror image. [cm] */
  readonly residual: number;
  /** Map of the face-up pieces, from the first of a pair to the second. */
  readonly map: MirrorMap;
}

/** A symmetry detected on a garment. */
export type DetectedSymmetry = Symmetry & Registration;

/** A requested symmetry, measured on the garment. */
export type MeasuredSymmetry = Symmetry &
  Registration & {
    /** True if a solve accepts it: the residual is at most 0.1 cm. */
    readonly mirrors: boolean;
  };

export interface DetectedSymmetries {
  readonly symmetries: readonly DetectedSymmetry[];
}
