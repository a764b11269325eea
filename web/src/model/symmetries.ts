import type {MirrorMap, Point} from './geometry.js';

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

/** Where a symmetry lies on the garment, and how well it holds. Not read where symmetries are asked for. */
export interface Registration {
  /** Greatest distance of an outline from its mirror image. [cm] */
  readonly residual: number;
  /** Of the pieces as they lie face up: from the first of a pair to the second. */
  readonly map: MirrorMap;
}

/** A symmetry that was found on a garment. */
export type DetectedSymmetry = Symmetry & Registration;

/** A symmetry that was asked for, as near as the garment comes to it. */
export type MeasuredSymmetry = Symmetry &
  Registration & {
    /** Whether a solve accepts it: the residual is at most 0.1 cm. */
    readonly mirrors: boolean;
  };

export interface DetectedSymmetries {
  readonly symmetries: readonly DetectedSymmetry[];
}
