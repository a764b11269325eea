import type {Alignment, Point} from './geometry.js';

/** `free`: any angle; `on`: grain line along the cloth; `across`: at a right angle to that; `bias`: at 45 degrees. */
export type GrainLock = 'free' | 'on' | 'across' | 'bias';

/** A lock, or more about one piece. */
export type GrainRule =
  | GrainLock
  | {
      /** As for all pieces when left out. */
      readonly lock?: GrainLock;
      readonly toleranceDeg?: number;
      /** Where the grain line of the face-up piece runs, counter-clockwise from its x axis, over what the file says. */
      readonly angleDeg?: number;
    };

/** What a rule says about the grain line itself. [degrees] */
export const angleOf = (rule: GrainRule | undefined): number | undefined =>
  typeof rule === 'object' ? rule.angleDeg : undefined;

/** A solver option left out has the default given here. */
export interface SolveOptions {
  readonly format?: 'seamwise-options/1';
  /** No outline vertex moves further than this from its rest position. [cm] Default 1. */
  readonly maxChangeCm?: number;
  /** Stiffness: the weight of the conformal energy (`paper`, `ws19`; default: chosen), or a factor of it (`best`). */
  readonly alpha?: number;
  /** Greatest distance of outline vertices, at most 1.05. [cm] Default 1. */
  readonly edgeLengthCm?: number;
  /** Forbid seams at which the print is mirrored. Default false. */
  readonly continuousOnly?: boolean;
  /** Seam lines take the mean of both sides' turning angles. Default: only for `paper`. */
  readonly averageSeamShapes?: boolean;
  /** Random starts of `paper` and `ws19`; with several, the drafted layout is one more. Default 1. */
  readonly starts?: number;
  /** Whether the ideal seam lines of `paper` and `ws19` stay within `maxChangeCm` of the drafted ones. Default false. */
  readonly clipTargets?: boolean;
  readonly grain?: {
    readonly default?: GrainLock;
    readonly toleranceDeg?: number;
    readonly pieces?: Readonly<Record<string, GrainRule>>;
  };
  /** Pieces, by name, whose alignment is given. */
  readonly pins?: Readonly<Record<string, Alignment>>;
  /** Weight of a seam while solving, by its number in the garment file; the figures do not use it. */
  readonly weights?: Readonly<Record<string, number>>;
  /** Seams, by number, at which the print need not match. */
  readonly unmatched?: readonly number[];
  /** Pieces, by name, that are cut from unprinted cloth. */
  readonly plain?: readonly string[];
  readonly matches?: readonly MatchedLines[];
  /** What stays as drafted, by the name of the piece; mirror images follow. */
  readonly locked?: Locks;
  /** Whether hems and other edges that are not sewn keep their line. Default `kept`. */
  readonly openEdges?: OpenEdges;
  /** How long to look for an answer, from 1, the default: one with more is never worse. */
  readonly effort?: number;
  /** Work for a proof of the alignment, as a multiple of the search's. Default: a little, where that may do. */
  readonly proof?: number;
  /** Whether the result tells of other alignments that fit about as well. Default false. */
  readonly otherAlignments?: boolean;
}

/** All of a piece, or edges of its outline by their number in the garment file. */
export type Lock = true | readonly number[];

export type Locks = Readonly<Record<string, Lock>>;

export type OpenEdges = 'kept' | 'free';

/** Two marked lines that lie on each other without being sewn (a button front, a patch pocket). */
export interface MatchedLines {
  readonly a: {readonly piece: string; readonly line: readonly Point[]};
  readonly b: {readonly piece: string; readonly line: readonly Point[]};
  readonly weight?: number;
}
