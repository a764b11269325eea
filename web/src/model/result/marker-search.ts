/**
 * Request and answer of the marker search, before the answer becomes a plan. Lengths in cm, angles
 * in radians.
 */
import type {Alignment, Point} from '../geometry/vectors.js';
import type {Repeat} from '../print/wallpaper.js';

/**
 * Direction of pieces on a print, or a pile, with an upside: any; the same for all pieces of a
 * garment; or the head of every grain line up the fabric.
 */
export const naps = ['none', 'garment', 'one-way'] as const;
export type Nap = (typeof naps)[number];

/**
 * Turns of the print by which a piece may be laid: half turns, which keep its grain; also quarter
 * turns; or any.
 */
export type LaidTurns = 'half' | 'quarter' | 'any';

export interface MarkerPiece {
  /** Name in messages. */
  readonly name: string;
  /** Index of its garment, from 0. */
  readonly garment: number;
  /** Cutting line without its holes in the coordinates of the piece's shape, counter-clockwise. */
  readonly outline: readonly Point[];
  readonly alignment: Alignment;
  readonly turns: LaidTurns;
  /** Direction from foot to head on the piece, of any length. */
  readonly up: Point;
  /** Shifts of the print under the piece that match as well as no shift. */
  readonly shifts: readonly Point[];
  /** Required place: p_fabric = R(angle) p + translation. */
  readonly pin?: Alignment;
}

export interface MarkerProblem {
  readonly print: Repeat;
  readonly pieces: readonly MarkerPiece[];
  /** Width between the edges of the fabric, and width of the unusable strip along each edge. */
  readonly widthCm: number;
  readonly selvedgeCm: number;
  /** Least distance between pieces. */
  readonly gapCm: number;
  /** Greatest relative deviation of the repeat on the bolt from the given one. */
  readonly repeatTolerance: number;
  readonly nap: Nap;
  /** True if the length is rounded up to whole repeats along the warp. */
  readonly wholeRepeats: boolean;
  /** True if pieces may be placed anywhere, without regard to the print. */
  readonly ignoresPrint: boolean;
  /**
   * Distances of an origin of the print from the left edge, at least one; the search chooses the
   * best one.
   */
  readonly phasesCm: readonly number[];
  /**
   * Distance of an origin of the print from the cut; undefined where the fabric is cut anywhere.
   */
  readonly startCm?: number;
  /** Polygons of the fabric that pieces must avoid. */
  readonly flaws: readonly (readonly Point[])[];
  /** Other widths of fabric, on which the pieces are laid out quickly. */
  readonly widthsCm: readonly number[];
  /** True to search also for a layout that ignores the print. */
  readonly alsoFree: boolean;
  /**
   * Multiplies the work; 1 is meant to take about a second. 0: the first layout only, and no proof.
   */
  readonly effort: number;
  /** A whole number from 0 to 4294967295. */
  readonly seed: number;
}

export interface MarkerLayout {
  readonly lengthCm: number;
  /** An origin of the print on the fabric. */
  readonly printOrigin: Point;
  /** Per piece, p_fabric = R(angle) p + translation; null where it found no place. */
  readonly places: readonly (Alignment | null)[];
}

export interface MarkerAnswer extends MarkerLayout {
  /** Lower bound: no layout with this start of the print is shorter. */
  readonly boundCm: number;
  readonly proven: boolean;
  /** Length without regard to the print; null unless requested. */
  readonly freeLengthCm: number | null;
  /** Lengths per phase and per width of the problem; null where a piece finds no place. */
  readonly phaseLengthsCm: readonly (number | null)[];
  readonly widthLengthsCm: readonly (number | null)[];
}

export type MarkerStage = 'tables' | 'lay' | 'prove' | 'free' | 'widths' | 'shifts' | 'done';

export interface MarkerProgress {
  readonly stage: MarkerStage;
  /** Share of the work done, 0 to 1. */
  readonly fraction: number;
}

/** Callbacks to follow the search for a layout, and a signal to end it early. */
export interface MarkerHooks {
  readonly signal?: AbortSignal;
  readonly onProgress?: (progress: MarkerProgress) => void;
  /** Receives each layout that is better than those before. */
  readonly onLayout?: (layout: MarkerLayout) => void;
}
