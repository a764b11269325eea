/**
 * Content of another program's file before any choice: pieces as drawn, right side up, y up, in the
 * unit of the file. `garmentOf` converts it to a garment.
 */
import type {DrawnGrain} from './grain.js';
import type {DraftedFold, FileUnit} from './garment-document.js';
import type {Point} from '../geometry/vectors.js';

/**
 * A line from corner to corner: a chain of Bezier curves, each given by two control points and its
 * end.
 */
export interface Run {
  readonly start: Point;
  readonly cubics: readonly (readonly [Point, Point, Point])[];
}

export type NotchKind = 'slit' | 'v' | 't' | 'castle' | 'check' | 'u';

export interface DrawnNotch {
  readonly at: Point;
  /** A second point in the direction of the notch, into the piece or out of it. */
  readonly towards?: Point;
  readonly depth?: number;
  readonly kind: NotchKind;
}

export interface DrawnPiece {
  readonly name: string;
  readonly size?: string;
  /** Numbers of pieces cut as drawn, and cut as the mirror image. */
  readonly quantity: {readonly asDrawn: number; readonly mirrored: number};
  readonly material?: string;
  /** The sewing line, closed, in either direction. A file with only one line gives this one. */
  readonly sewn: readonly Run[];
  /** The cutting line, if the file draws both. */
  readonly cut?: readonly Run[];
  readonly holes: readonly (readonly Run[])[];
  /** Indices of holes that may be lines drawn on the piece. */
  readonly doubtfulHoles?: readonly number[];
  readonly notches: readonly DrawnNotch[];
  readonly grain?: readonly [Point, Point];
  /** All grain lines, if the file draws several. */
  readonly grains?: readonly DrawnGrain[];
  /** Axis of a half piece, along which the fabric is folded. */
  readonly fold?: readonly [Point, Point];
  readonly internalLines: readonly (readonly Point[])[];
  /** Names of internal lines by their numbers, if the file states any. */
  readonly lineNames?: readonly (string | undefined)[];
  /** Pleats, tucks and creases, if the file names any. */
  readonly folds?: readonly DraftedFold[];
  readonly drillHoles: readonly Point[];
  readonly words: readonly string[];
  /** The reason why the piece may be none, and is left out unless it is chosen. */
  readonly doubt?: string;
}

/** Two runs of outlines that the file sews to each other; only meshes contain seams. */
export interface DrawnSeam {
  readonly a: {readonly piece: number; readonly run: number};
  readonly b: {readonly piece: number; readonly run: number};
  readonly sameDirection: boolean;
}

export interface UnitGuess {
  readonly unit: FileUnit;
  /** Evidence for the unit. */
  readonly because: 'stated' | 'measured' | 'size' | 'program';
  readonly isSure: boolean;
  /** Other units in which the garment is wearable. */
  readonly others: readonly FileUnit[];
}

export interface Drawing {
  readonly kind: 'dxf' | 'svg' | 'obj' | 'pdf';
  readonly program?: string;
  readonly title?: string;
  /**
   * All sizes in the file; `pieces` are those of `sampleSize` unless another size was requested.
   */
  readonly sizes: readonly string[];
  readonly sampleSize?: string;
  readonly size?: string;
  readonly unit: UnitGuess;
  readonly pieces: readonly DrawnPiece[];
  readonly seams: readonly DrawnSeam[];
  /** Omissions and assumptions, one sentence each. */
  readonly notes: readonly string[];
  /** The assembled pages of a PDF. */
  readonly pages?: AssembledPages;
}

/** Pages of a PDF as they are put together. Lengths in mm, y up, in coordinates of the pieces. */
export interface AssembledPages {
  /** Number of pages of the file. */
  readonly count: number;
  readonly placed: readonly {
    /** Page number, from 1. */
    readonly number: number;
    /** Column and row from 0; undefined for pages without joints. */
    readonly cell?: readonly [column: number, row: number];
    /** Corners of the shown part. */
    readonly low: Point;
    readonly high: Point;
  }[];
  /** Pages that are left out. */
  readonly others: readonly number[];
  readonly columns: number;
  readonly rows: number;
  /** Overlap of neighbouring pages across and down; undefined without joints. [cm] */
  readonly overlapCm?: readonly [across: number, down: number];
  /** Strip at the left side of pages beside the drawn part; undefined without joints. [cm] */
  readonly trimCm?: number;
  /** Pairs of pages with lines that end at their joint. */
  readonly openJoints: readonly {
    readonly pages: readonly [number, number];
    readonly misses: number;
  }[];
}

/** A page of a PDF in the grid of pages. */
export interface PagePlace {
  /** Page number, from 1. */
  readonly number: number;
  /** Column and row from 0, from the upper left. */
  readonly cell: readonly [column: number, row: number];
}

/** Options for reading a file. */
export interface DrawingOptions {
  /**
   * Size to take from a nest of sizes. Default: the base size, from which the others were graded.
   */
  readonly size?: string;
  /** Unit of the drawing; it overrides the unit in the file. */
  readonly units?: FileUnit;
  /** Pixels per inch of an SVG file, instead of `units`. */
  readonly pixelsPerInch?: number;
  /** Denominator of the scale 1 : n of a reduced drawing. Default 1. */
  readonly scale?: number;
  /** Page numbers of a PDF, from 1. Default: those with a pattern. */
  readonly pages?: readonly number[];
  /** Page numbers of a PDF that keep their place in the grid and show nothing. */
  readonly without?: readonly number[];
  /** Columns and rows of the pages of a PDF, in reading order. */
  readonly grid?: readonly [columns: number, rows: number];
  /** Places of the pages of a PDF, instead of `pages` and `grid`. */
  readonly places?: readonly PagePlace[];
  /** Strip at each side of the pages of a PDF that is cut off. [cm] */
  readonly trimCm?: number;
  /** Overlap of neighbouring pages of a PDF, after trimming. [cm] */
  readonly overlapCm?: number;
  /** Seam allowance that the lines of a PDF include; 0 for sewn lines. [cm] */
  readonly allowanceCm?: number;
}

const drawingEnding =
  /(\.(aama|astm|browzwear|clo|flat|gerber|lectra|optitex|polypattern|richpeace|valentina))?\.(dxf|obj|pdf|svg)$/i;

/** Name of a drawing file without the endings that programs add: "tee-m" of "tee-m.gerber.dxf". */
export const drawingName = (file: string): string =>
  file.replace(/^.*[/\\]/, '').replace(drawingEnding, '') || file;

/** Least length at which programs cut names off. [characters] */
const shortestCut = 20;

/**
 * Title of a drawing. The stated title may be a file name, or the cut-off beginning of this file's
 * own name.
 */
export function drawingTitle(stated: string, file: string): string {
  const [title, own] = [drawingName(stated.trim()), drawingName(file)];
  return title.length >= shortestCut && own.startsWith(title) ? own : title;
}
