/**
 * The cutting sheet: pieces laid out on one sheet, from which SVG, PDF and DXF are drawn. Lengths
 * are in cm on the sheet, y up, from its lower left corner. Line widths and letter sizes are in mm.
 */
import type {Alignment, Point} from '../model/geometry/vectors.js';
import type {OwnShare} from './allowances.js';
import type {CutFold} from './fold-marks.js';

/** Least letter size on paper, 7.4 pt. */
export const leastLetterMm = 2.6;

export type CutLayer = 'print' | 'cut' | 'sew' | 'marks' | 'matches' | 'words';

export interface CutLine {
  readonly kind: 'line';
  readonly layer: CutLayer;
  readonly points: readonly Point[];
  readonly isClosed: boolean;
  readonly widthMm: number;
  readonly dashMm?: readonly number[];
  /** A light line beneath, wider by this amount, which keeps the line visible on any print. */
  readonly haloMm?: number;
  /** Drawn translucent over the print. */
  readonly isFaint?: boolean;
}

/** Lines of text, aligned at a point. */
export interface CutText {
  readonly kind: 'text';
  readonly layer: CutLayer;
  readonly at: Point;
  readonly lines: readonly string[];
  readonly sizeMm: number;
  /** Drawn on a light plate, which keeps the text legible on any print. */
  readonly hasPlate: boolean;
  /** Rotation counter-clockwise. [rad] Default 0. */
  readonly angle?: number;
  /** Alignment at the point. Default middle. */
  readonly align?: 'left' | 'middle' | 'right';
  /** Weight of all lines. Default: bold for the first line, regular for the others. */
  readonly weight?: 'regular' | 'bold';
}

export type CutMark = CutLine | CutText;

export interface LaidPiece {
  readonly name: string;
  readonly label: string;
  /** Number among several copies, from 1. */
  readonly copy: number;
  /** Transform from shape coordinates to the sheet: p_sheet = R(angle) p + translation. */
  readonly place: Alignment;
  /** Alignment of the piece on the print; undefined for plain fabric. */
  readonly alignment?: Alignment;
  /** The outline, then the holes. */
  readonly cut: readonly (readonly Point[])[];
  readonly sewn: readonly (readonly Point[])[];
  /** Corners between edges of the sewn lines. */
  readonly corners: readonly Point[];
  readonly notches: readonly {
    /** Position on the sewn line. */
    readonly at: Point;
    /** Direction towards the allowance, counter-clockwise from x. [rad] */
    readonly angle: number;
    /** Distance to the cut line. */
    readonly allowanceCm: number;
    /** Depth of the slit from the cut line; 0 if the allowance is too narrow to cut into. */
    readonly depthCm: number;
    readonly seam?: number;
  }[];
  readonly grain: readonly [Point, Point];
  /** Numbered crosses that all mark the same point of the print. */
  readonly matchPoints: readonly {readonly at: Point; readonly number: number}[];
  /**
   * Ticks on seams. Two ticks of one label are at the same point of the print, up to its
   * symmetries.
   */
  readonly ticks: readonly {
    readonly at: Point;
    /** Direction of the tick's line of the print. [rad] */
    readonly angle: number;
    readonly label: string;
    readonly seam: number;
  }[];
  /** Lines of the print through the first cross, across and along the grain. */
  readonly stripe?: readonly [Point, Point];
  readonly plaid?: readonly [Point, Point];
  /** Seam letters beside edges, inside the piece; edges with the same letter are sewn together. */
  readonly letters: readonly {readonly letter: string; readonly at: Point}[];
  readonly internalLines: readonly (readonly Point[])[];
  readonly folds: readonly CutFold[];
  readonly drillHoles: readonly Point[];
  /** Number of copies to cut. */
  readonly quantity: number;
  /** Material, if other than the printed fabric. */
  readonly material?: string;
  /** Text on the piece by line; the first line is its label. */
  readonly words: readonly string[];
  readonly marks: readonly CutMark[];
}

/** A sheet without margins, on which pieces keep a distance from each other. */
export interface CutSheet {
  readonly widthCm: number;
  readonly heightCm: number;
  readonly pieces: readonly LaidPiece[];
  /** Name and size of the garment. */
  readonly heading: string;
  readonly title?: string;
  readonly size?: string;
  /** Locale of the texts. Default 'en'. */
  readonly locale?: string;
  /** The share of edges whose allowance is specified by the garment rather than the user. */
  readonly ownAllowances: OwnShare;
  /** Instructions, one sentence each. */
  readonly facts: readonly string[];
}
