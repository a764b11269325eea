/**
 * Pieces to cut, laid out on one sheet of paper: neither SVG nor PDF nor DXF, which are drawn from it. Lengths are in cm
 * on the sheet, y up, from its lower left corner, but for widths of lines and sizes of letters, which are in mm.
 */
import type {Alignment, Point} from '../model/geometry.js';
import type {OwnShare} from './allowances.js';

export type CutLayer = 'print' | 'cut' | 'sew' | 'marks' | 'matches' | 'words';

export interface CutLine {
  readonly kind: 'line';
  readonly layer: CutLayer;
  readonly points: readonly Point[];
  readonly isClosed: boolean;
  readonly widthMm: number;
  readonly dashMm?: readonly number[];
  /** A light line beneath, wider by so much, so that it shows on any print. */
  readonly haloMm?: number;
  /** Drawn so that the print shows through. */
  readonly isFaint?: boolean;
}

/** Words one below the other, their middle at a point, or that of their left or right edge. */
export interface CutText {
  readonly kind: 'text';
  readonly layer: CutLayer;
  readonly at: Point;
  readonly lines: readonly string[];
  readonly sizeMm: number;
  /** On a light ground, so that they show on any print. */
  readonly hasPlate: boolean;
  /** Counter-clockwise. [rad] Default 0. */
  readonly angle?: number;
  /** Default middle. */
  readonly align?: 'left' | 'middle' | 'right';
  /** Of all lines. Default bold for the first, regular for the others. */
  readonly weight?: 'regular' | 'bold';
}

export type CutMark = CutLine | CutText;

export interface LaidPiece {
  readonly name: string;
  readonly label: string;
  /** Which of several equal ones, from 1. */
  readonly copy: number;
  /** Points of the piece's shape -> sheet: p_sheet = R(angle) p + translation. */
  readonly place: Alignment;
  /** Where the piece lies on the print; none of unprinted cloth. */
  readonly alignment?: Alignment;
  /** The outline, then the holes. */
  readonly cut: readonly (readonly Point[])[];
  readonly sewn: readonly (readonly Point[])[];
  /** Where edges of the sewn lines meet. */
  readonly corners: readonly Point[];
  readonly notches: readonly {
    /** On the sewn line. */
    readonly at: Point;
    /** Of the line from there towards the allowance, from x, counter-clockwise. [rad] */
    readonly angle: number;
    /** From there to the cut line. */
    readonly allowanceCm: number;
    /** Of the slit, from the cut line; 0 where there is too little to cut into. */
    readonly depthCm: number;
    readonly seam?: number;
  }[];
  readonly grain: readonly [Point, Point];
  /** Numbered crosses on one and the same point of the print. */
  readonly matchPoints: readonly {readonly at: Point; readonly number: number}[];
  /** On seams: two of one label lie on one and the same point of the print, but for its symmetries. */
  readonly ticks: readonly {
    readonly at: Point;
    /** Of the line of the print that they lie on. [rad] */
    readonly angle: number;
    readonly label: string;
    readonly seam: number;
  }[];
  /** Lines of the print through the first cross, across and along the grain. */
  readonly stripe?: readonly [Point, Point];
  readonly plaid?: readonly [Point, Point];
  /** Beside edges, inside: what has the same letter is sewn together. */
  readonly letters: readonly {readonly letter: string; readonly at: Point}[];
  readonly internalLines: readonly (readonly Point[])[];
  readonly drillHoles: readonly Point[];
  /** How many are cut of it. */
  readonly quantity: number;
  /** Of material other than the print's. */
  readonly material?: string;
  /** What stands on it, line by line; the first is its label. */
  readonly words: readonly string[];
  readonly marks: readonly CutMark[];
}

/** Pieces on it keep their distance from each other; it has no margin. */
export interface CutSheet {
  readonly widthCm: number;
  readonly heightCm: number;
  readonly pieces: readonly LaidPiece[];
  /** Name and size of the garment. */
  readonly heading: string;
  readonly title?: string;
  readonly size?: string;
  /** How many edges have an allowance that the garment says, and not whoever cuts it. */
  readonly ownAllowances: OwnShare;
  /** What a maker has to know, a sentence each. */
  readonly facts: readonly string[];
}
