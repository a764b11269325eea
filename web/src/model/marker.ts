/** What is asked about laying pieces on cloth, and what the answer says before it is a plan. Lengths in cm, angles in radians. */
import type {Alignment, Point} from './geometry.js';
import type {Repeat} from './wallpaper.js';

/**
 * Which way the pieces lie of a print, or a pile, with an upside: as they like; all of one garment the same way; or all
 * with the head of their grain line up the cloth.
 */
export const naps = ['none', 'garment', 'one-way'] as const;
export type Nap = (typeof naps)[number];

/** By which turns of the print a piece may be laid: half turns, which keep its grain; quarter turns too; or any. */
export type LaidTurns = 'half' | 'quarter' | 'any';

export interface MarkerPiece {
  /** As sentences call it. */
  readonly name: string;
  /** Which garment it belongs to, from 0. */
  readonly garment: number;
  /** The cut line without its holes in the coordinates of the piece's shape, counter-clockwise. */
  readonly outline: readonly Point[];
  readonly alignment: Alignment;
  readonly turns: LaidTurns;
  /** From foot to head, on the piece; of any length. */
  readonly up: Point;
  /** Shifts of the print under it that fit as well, beside none. */
  readonly shifts: readonly Point[];
  /** Where it has to lie: p_cloth = R(angle) p + translation. */
  readonly pin?: Alignment;
}

export interface MarkerProblem {
  readonly print: Repeat;
  readonly pieces: readonly MarkerPiece[];
  /** Of the cloth, between its edges, and what is of no use along each of them. */
  readonly widthCm: number;
  readonly selvedgeCm: number;
  /** Between pieces. */
  readonly gapCm: number;
  /** How much the repeat on the bolt may be longer or shorter than told, as a share. */
  readonly repeatTolerance: number;
  readonly nap: Nap;
  /** The length is rounded up to whole repeats along the warp. */
  readonly wholeRepeats: boolean;
  /** Pieces lie wherever they fit. */
  readonly ignoresPrint: boolean;
  /** Distances of an origin of the print from the left edge, the best of which is chosen; at least one. */
  readonly phasesCm: readonly number[];
  /** Of an origin of the print from the cut; undefined where the cloth is cut anywhere. */
  readonly startCm?: number;
  /** Polygons of the cloth on which no piece may lie. */
  readonly flaws: readonly (readonly Point[])[];
  /** Of other cloths, on which the pieces are laid quickly. */
  readonly widthsCm: readonly number[];
  /** Whether to lay without regard to the print, too. */
  readonly alsoFree: boolean;
  /** Multiplies the work; 1 is meant to take about a second. 0: the first layout only, and no proof. */
  readonly effort: number;
  /** A whole number from 0 to 4294967295. */
  readonly seed: number;
}

export interface MarkerLayout {
  readonly lengthCm: number;
  /** Where an origin of the print lies on the cloth. */
  readonly printOrigin: Point;
  /** Per piece p_cloth = R(angle) p + translation; null where it found no place. */
  readonly places: readonly (Alignment | null)[];
}

export interface MarkerAnswer extends MarkerLayout {
  /** No layout with the print starting there is shorter. */
  readonly boundCm: number;
  readonly proven: boolean;
  /** Null where nobody asked. */
  readonly freeLengthCm: number | null;
  /** Per phase and per width of the problem; null where a piece finds no place. */
  readonly phaseLengthsCm: readonly (number | null)[];
  readonly widthLengthsCm: readonly (number | null)[];
}

export type MarkerStage = 'tables' | 'lay' | 'prove' | 'free' | 'widths' | 'shifts' | 'done';

export interface MarkerProgress {
  readonly stage: MarkerStage;
  /** 0 to 1 */
  readonly fraction: number;
}

/** How to follow the search for a layout and how to end it early. */
export interface MarkerHooks {
  readonly signal?: AbortSignal;
  readonly onProgress?: (progress: MarkerProgress) => void;
  /** Each layout that is better than those before. */
  readonly onLayout?: (layout: MarkerLayout) => void;
}
