/** Pieces laid on a bolt of printed cloth, as `seamwise-layplan/1`: x across from the left edge, y along the warp from the cut. [cm] */
import type {Alignment, Point} from './geometry.js';
import type {LayNote} from './lay-note.js';
import type {GroupName} from './print.js';

/** A piece on the cloth, face up. */
export interface LaidPlacement {
  /** Which of the results that are laid, and which of several equal garments; both from 0. */
  readonly result: number;
  readonly copy: number;
  readonly piece: string;
  /** Which of several that are cut of the piece for one garment, from 0; absent of one. */
  readonly nth?: number;
  /** p_cloth = R(angle) p + translation, p a point of the piece's `shape`. [rad, cm] */
  readonly angle: number;
  readonly translation: Point;
  /** The cut line on the cloth, counter-clockwise. */
  readonly cut: readonly Point[];
}

/** What a layout takes where the print starts elsewhere, or on other cloth; null where a piece finds no place. */
export interface PhaseLength {
  /** Of the print's origin from the left edge. [cm] */
  readonly phaseCm: number;
  readonly lengthCm: number | null;
}
export interface WidthLength {
  readonly widthCm: number;
  readonly lengthCm: number | null;
}

/** A change of the placing that costs no fit to speak of, and what it would take then. */
export interface CheaperLay {
  /**
   * The print starts elsewhere; it moves under pieces where it fits as well; it need not match on pieces; or all pieces of
   * a result lie as in another design that fits as well.
   */
  readonly kind: 'phase' | 'shift' | 'unmatched' | 'design';
  readonly lengthCm: number;
  /** Of `phase`: from the left edge to an origin of the print. */
  readonly phaseCm?: number;
  /** Of `shift` and `unmatched`: names of the pieces that show another part of the print. */
  readonly pieces?: readonly string[];
  readonly design?: CheaperDesign;
}

/** Another design of a result. */
export interface CheaperDesign {
  readonly result: number;
  /** By name where its pieces lie: as `pins` of the options they are that design. */
  readonly pins: Readonly<Record<string, Alignment>>;
  /** By how much the print misses at the seams on average, and in the design that is laid. [cm] */
  readonly meanCm: number;
  readonly insteadOfCm: number;
}

export interface LayPlan {
  readonly format: 'seamwise-layplan/1';
  readonly print: {readonly group: GroupName; readonly w1: Point; readonly w2: Point};
  /** Between its edges, and what is of no use along each of them. */
  readonly widthCm: number;
  readonly selvedgeCm: number;
  /** Between pieces. */
  readonly gapCm: number;
  readonly allowanceCm: number;
  readonly lengthCm: number;
  /** Where the cloth is folded, from its left edge; it is shown spread. Absent of single cloth. */
  readonly foldCm?: number;
  /** Where an origin of the print lies on the cloth; null for a layout that ignores the print. */
  readonly printOrigin: Point | null;
  readonly placements: readonly LaidPlacement[];
  readonly unplaced: readonly {
    readonly result: number;
    readonly copy: number;
    readonly piece: string;
    readonly nth?: number;
  }[];
  /** Area of the pieces / (width x length). */
  readonly useShare: number;
  /** No layout with the print starting here is shorter. */
  readonly boundCm: number;
  /** Whether the bound is the length. */
  readonly proven: boolean;
  /** Of the same pieces, laid with as much effort without regard to the print and to pins; null where that is not known. */
  readonly freeLengthCm: number | null;
  /** Of the same pieces on the print before any was pinned, null where they were not laid so; absent where none is pinned. */
  readonly unpinnedLengthCm?: number | null;
  /** By where the print starts, where that was not said; else the one phase. */
  readonly phases: readonly PhaseLength[];
  readonly widths: readonly WidthLength[];
  readonly cheaper: readonly CheaperLay[];
  readonly notes: readonly string[];
  /** What each of them says, as code and values. */
  readonly noteDetails: readonly LayNote[];
}
