import type {Alignment, Point} from '../geometry/vectors.js';
import type {GrainLock, GrainRule} from '../garment/grain.js';

/** Options of the solver. Each omitted option has the default given here. */
export interface SolveOptions {
  readonly format?: 'seamwise-options/1';
  /** Greatest distance of an outline vertex from its rest position. [cm] Default 1. */
  readonly maxChangeCm?: number;
  /**
   * Stiffness: the weight of the conformal energy (`paper`, `ws19`; default: chosen), or a factor
   * of it (`best`).
   */
  readonly alpha?: number;
  /** Greatest distance between outline vertices, at most 1.05. [cm] Default 1. */
  readonly edgeLengthCm?: number;
  /** Forbid seams at which the print is mirrored. Default false. */
  readonly continuousOnly?: boolean;
  /** Seam lines take the mean of both sides' turning angles. Default: only for `paper`. */
  readonly averageSeamShapes?: boolean;
  /**
   * Number of random starts of `paper` and `ws19`. Several starts include the drafted layout as an
   * additional one. Default 1.
   */
  readonly starts?: number;
  /**
   * True if the ideal seam lines of `paper` and `ws19` stay within `maxChangeCm` of the drafted
   * ones. Default false.
   */
  readonly clipTargets?: boolean;
  readonly grain?: {
    readonly default?: GrainLock;
    readonly toleranceDeg?: number;
    readonly pieces?: Readonly<Record<string, GrainRule>>;
  };
  /** Given alignments of pieces, by name. */
  readonly pins?: Readonly<Record<string, Alignment>>;
  /**
   * Weights of seams in the solve, by number in the garment file; the reported figures ignore them.
   */
  readonly weights?: Readonly<Record<string, number>>;
  /** Numbers of seams at which the print need not match. */
  readonly unmatched?: readonly number[];
  /** Names of pieces that are cut from unprinted fabric. */
  readonly plain?: readonly string[];
  readonly matches?: readonly MatchedLines[];
  /** Parts that stay as drafted, by the name of the piece; mirror images are included. */
  readonly locked?: Locks;
  /** Hems and other unsewn edges: `kept` as drafted, or `free` to change. Default `kept`. */
  readonly openEdges?: OpenEdges;
  /**
   * Default weights of seams: by how much a seam is seen at its place on the body (`place`), or the
   * same for all (`even`). Default `place`.
   */
  readonly visibility?: Visibility;
  /** Effort of the search, from 1, the default. A result with more effort is never worse. */
  readonly effort?: number;
  /**
   * Work for a proof of the alignment, as a multiple of the search's. Default: a little, where that
   * may suffice.
   */
  readonly proof?: number;
  /** True if the result lists other alignments that match about as well. Default false. */
  readonly otherAlignments?: boolean;
}

/**
 * Sizes of the print, as multiples of its size: one size; some, such as those that a shop offers;
 * or a range. Several sizes are compared, always with the print's own, and the best one is taken.
 */
export type PrintSizes =
  number | {readonly sizes: readonly number[]} | {readonly from: number; readonly to: number};

/**
 * Counter-clockwise turns of the print on its fabric: one turn, or some, which are compared with no
 * turn. The best one is taken. [degrees]
 */
export type PrintTurns = number | {readonly turns: readonly number[]};

/**
 * Options of a problem. Those beyond `SolveOptions` ask for several solves, of which the best
 * answer counts; a design never stores them.
 */
export interface ProblemOptions extends Omit<SolveOptions, 'effort'> {
  /**
   * As in `SolveOptions`; or `auto`: searches with other seeds, until four in a row gain nothing or
   * eight are tried.
   */
  readonly effort?: number | 'auto';
  /** Sizes of the print among which the best one is chosen. Default: the print's own. */
  readonly printSize?: PrintSizes;
  /** Turns of the print among which the best one is chosen. Default: no turn. */
  readonly printTurn?: PrintTurns;
}

/** A whole piece, or edges of its outline by number in the garment file. */
export type Lock = true | readonly number[];

export type Locks = Readonly<Record<string, Lock>>;

export type OpenEdges = 'kept' | 'free';

export type Visibility = 'place' | 'even';

/** Two marked lines that coincide without being sewn (a button front, a patch pocket). */
export interface MatchedLines {
  readonly a: {readonly piece: string; readonly line: readonly Point[]};
  readonly b: {readonly piece: string; readonly line: readonly Point[]};
  readonly weight?: number;
}
