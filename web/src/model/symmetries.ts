import type {Point} from './geometry.js';

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

/** A symmetry that was found, with the greatest distance of an outline from its mirror image. [cm] */
export type DetectedSymmetry = Symmetry & {readonly residual: number};

export interface DetectedSymmetries {
  readonly symmetries: readonly DetectedSymmetry[];
}
