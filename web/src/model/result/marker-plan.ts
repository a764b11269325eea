/**
 * A marker, as `seamwise-layplan/1`: pieces laid out on a bolt of printed fabric. x runs across
 * from the left edge, y along the warp from the cut. [cm]
 */
import type {Alignment, Point} from '../geometry/vectors.js';
import type {LayNote} from './lay-note.js';
import type {GroupName} from '../print/repeating-print.js';

/** A piece on the fabric, face up. */
export interface LaidPlacement {
  /** Index of the result, and of the garment among several equal ones; both from 0. */
  readonly result: number;
  readonly copy: number;
  readonly piece: string;
  /** Index among several copies of the piece for one garment, from 0; absent for a single one. */
  readonly nth?: number;
  /** p_fabric = R(angle) p + translation, p a point of the piece's `shape`. [rad, cm] */
  readonly angle: number;
  readonly translation: Point;
  /** Cutting line on the fabric, counter-clockwise. */
  readonly cut: readonly Point[];
}

/**
 * Length of a layout with another start of the print, or on another width; null where a piece finds
 * no place.
 */
export interface PhaseLength {
  /** Distance of the print's origin from the left edge. [cm] */
  readonly phaseCm: number;
  readonly lengthCm: number | null;
}
export interface WidthLength {
  readonly widthCm: number;
  readonly lengthCm: number | null;
}

/**
 * A change that shortens the layout and hardly affects the match of the print, and the length after
 * it.
 */
export interface CheaperLay {
  /**
   * `phase`: the print starts elsewhere; `shift`: it moves under pieces where it matches as well;
   * `unmatched`: it need not match on pieces; `design`: all pieces of a result are aligned as in
   * another design that matches as well.
   */
  readonly kind: 'phase' | 'shift' | 'unmatched' | 'design';
  readonly lengthCm: number;
  /** For `phase`: distance from the left edge to an origin of the print. */
  readonly phaseCm?: number;
  /** For `shift` and `unmatched`: names of the pieces that show another part of the print. */
  readonly pieces?: readonly string[];
  readonly design?: CheaperDesign;
}

/** Another design of a result. */
export interface CheaperDesign {
  readonly result: number;
  /** Alignments of its pieces by name; used as `pins` of the options, they give that design. */
  readonly pins: Readonly<Record<string, Alignment>>;
  /** Mean mismatch at the seams in this design, and in the design of the layout. [cm] */
  readonly meanCm: number;
  readonly insteadOfCm: number;
}

/** All garments of one result in a layout. */
export interface GarmentShare {
  /** Index of the result, from 0. */
  readonly result: number;
  /** Number of garments. */
  readonly copies: number;
  /** Number of pieces of all copies, unplaced ones included. */
  readonly pieces: number;
  /** Area of the placed pieces within their cut lines. [cm2] */
  readonly areaCm2: number;
  /** Part of the length of the layout, by area. [cm] */
  readonly lengthCm: number;
}

export interface LayPlan {
  readonly format: 'seamwise-layplan/1';
  readonly print: {readonly group: GroupName; readonly w1: Point; readonly w2: Point};
  /** Width between the edges of the fabric, and width of the unusable strip along each edge. */
  readonly widthCm: number;
  readonly selvedgeCm: number;
  /** Least distance between pieces. */
  readonly gapCm: number;
  readonly allowanceCm: number;
  /** Allowance at hems. Absent in layouts of earlier versions. */
  readonly hemCm?: number;
  readonly lengthCm: number;
  /**
   * Distance of the fold from the left edge; the fabric is shown unfolded. Absent for single
   * fabric.
   */
  readonly foldCm?: number;
  /** An origin of the print on the fabric; null for a layout that ignores the print. */
  readonly printOrigin: Point | null;
  readonly placements: readonly LaidPlacement[];
  readonly unplaced: readonly {
    readonly result: number;
    readonly copy: number;
    readonly piece: string;
    readonly nth?: number;
  }[];
  /** One entry per result. Absent in layouts of earlier versions. */
  readonly garments?: readonly GarmentShare[];
  /** Area of the pieces / (width x length). */
  readonly useShare: number;
  /** Lower bound: no layout with this start of the print is shorter. */
  readonly boundCm: number;
  /** True if the bound equals the length. */
  readonly proven: boolean;
  /**
   * Length of the same pieces laid out with the same effort, without regard to print and pins; null
   * where unknown.
   */
  readonly freeLengthCm: number | null;
  /**
   * Length of the same pieces on the print before any of them was pinned; null where unknown,
   * absent without pins.
   */
  readonly unpinnedLengthCm?: number | null;
  /** Lengths by start of the print if that was not given; otherwise the single one. */
  readonly phases: readonly PhaseLength[];
  readonly widths: readonly WidthLength[];
  readonly cheaper: readonly CheaperLay[];
  readonly notes: readonly string[];
  /** Codes and values of `notes`. */
  readonly noteDetails: readonly LayNote[];
}
