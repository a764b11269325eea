import type {Alignment, MirrorMap, Point} from '../geometry/vectors.js';
import type {NoteDetail} from './notes.js';
import type {Delivered, GroupName} from '../print/repeating-print.js';
import type {FoldKind} from '../garment/garment-document.js';
import type {Method} from './method.js';

/** A piece before and after: `rest` and `shape` share vertices, triangles and outline. [cm] */
export interface ResultPiece {
  readonly name: string;
  readonly rest: readonly Point[];
  readonly shape: readonly Point[];
  readonly triangles: readonly (readonly [number, number, number])[];
  /** Vertex numbers, counter-clockwise. */
  readonly outline: readonly number[];
  /** Cut-outs as vertex numbers, clockwise. */
  readonly holes: readonly (readonly number[])[];
  readonly alignment: Alignment;
  /** True if the file showed the back of the panel, so that x was negated. */
  readonly mirroredFromInput: boolean;
  /** Direction of the grain line. [rad] */
  readonly grainAngle?: number;
  /**
   * Placement of the input panel: turned about the fixed axes x, then y, then z [rad], then shifted
   * [cm].
   */
  readonly placement?: {
    readonly translation: readonly [number, number, number];
    readonly rotation: readonly [number, number, number];
  };
  /** Pleats and tucks, on the piece as drafted. */
  readonly folds?: readonly ResultFold[];
}

/** A pleat or tuck: `line` is laid on `to`. [cm] */
export interface ResultFold {
  readonly line: readonly [Point, Point];
  readonly to: readonly [Point, Point];
  readonly kind: FoldKind;
}

/** A line on a piece that coincides with one on another piece without being sewn. [cm] */
export interface ResultMatchSide {
  readonly piece: number;
  /** Points on the piece as drafted, face up. */
  readonly line: readonly Point[];
}

/** Vertices of one piece in sewing order. */
export interface SeamSide {
  readonly piece: number;
  readonly vertices: readonly number[];
}

/** Vertex i of side a is sewn to vertex i of side b. */
export interface ResultSeam {
  readonly a: SeamSide;
  readonly b: SeamSide;
  readonly weight: number;
  /** False: sewn, but the user has switched off the match. */
  readonly matched: boolean;
  /** Rest length of side a / rest length of side b. */
  readonly lengthRatio: number;
  /** The print continues across the seam, or is mirrored at it. */
  readonly kind: 'continuous' | 'mirrored';
  /**
   * Print mismatch per seam edge, under the one symmetry of the print that carries the whole seam.
   * It shows the course of the mismatch along the seam. [cm]
   */
  readonly mismatch: readonly number[];
  /** Mean of `mismatch`. [cm] */
  readonly whole?: number;
  readonly local?: LocalMismatch;
  /** `drafted`: the shaping has left the seam unchanged. */
  readonly line?: 'shaped' | 'drafted';
  /** Reason for a mismatch above 3 mm; absent for other seams. */
  readonly why?: SeamReason;
}

/**
 * Mean mismatch along a seam point by point, each under the allowed symmetry of the print that
 * suits it best. [cm]
 */
export interface LocalMismatch {
  /** Mean for the pieces as drafted, laid on grain. */
  readonly drafted: number;
  /** Mean for the pieces as drafted, under the final alignment. */
  readonly placed: number;
  /** Mean for the result. */
  readonly final: number;
}

/**
 * Reasons why a print does not match at a seam. `grain`: the grain lines of its pieces run across
 * each other; `gather`: one side is gathered; `group`: the print has no mirror for it; `size`: the
 * size of the repeat; `others`: its pieces follow other seams; `locked`: it is locked.
 */
export type SeamReason = 'grain' | 'gather' | 'group' | 'size' | 'others' | 'locked';

/** Places of seams on the body. */
export type SeamPlace =
  | 'other'
  | 'centre front'
  | 'centre back'
  | 'side'
  | 'shoulder'
  | 'princess'
  | 'yoke'
  | 'waist'
  | 'sleeve head, front'
  | 'sleeve head, back'
  | 'sleeve'
  | 'inseam'
  | 'outseam'
  | 'crotch'
  | 'band'
  | 'cuff'
  | 'collar'
  | 'hood'
  | 'pocket'
  | 'dart'
  | 'facing'
  | 'inside';

/**
 * `matches`: 95 % of the length within 3 mm; `close`: within 6 mm, or all but one short end
 * matches; `cannot`: no alignment and no allowed shape matches it; `choice`: left out by the user.
 */
export type SeamState = 'matches' | 'close' | 'off' | 'cannot' | 'choice';

/** Consecutive stitches that a sewist calls one seam. */
export interface SeamGroup {
  /** Indices of its seams. */
  readonly seams: readonly number[];
  readonly place: SeamPlace;
  /** The wearer's side; absent in the middle of the body. */
  readonly side?: 'left' | 'right';
  /** Visibility of a mismatch: 1.5 or more is seen at first sight. */
  readonly visibility: number;
  readonly state: SeamState;
  /** Reason why it does not match. */
  readonly reason?: SeamReason | 'reach';
  /** The end that does not match while the rest does, as worn. */
  readonly unmatchedEnd?: {
    readonly from: 'top' | 'bottom' | 'left' | 'right';
    readonly cm: number;
  };
}

/** An imposed symmetry; `pairs` cover every outline vertex. */
export type ResultSymmetry =
  | {
      readonly kind: 'piece';
      readonly piece: number;
      readonly map: MirrorMap;
      readonly pairs: readonly (readonly [number, number])[];
    }
  | {
      readonly kind: 'pair';
      readonly pieces: readonly [number, number];
      readonly map: MirrorMap;
      readonly pairs: readonly (readonly [number, number])[];
    };

/** Time spent computing, without the pauses between slices. [ms] */
export interface Milliseconds {
  readonly alignment: number;
  /** Time of the last attempt, if a method makes several with growing weights. */
  readonly deformation: number;
  /** Time of all attempts at the deformation; missing in files of earlier versions. */
  readonly attempts?: number;
  /** Time of both phases, and of reading, meshing and measuring around them. */
  readonly total: number;
}

/** Sums of edge length times print mismatch over the seams that count. [cm2] */
export interface Fits {
  /** Mean over random alignments of `rest`. */
  readonly fitRandom: number;
  /** Fit of the pieces as drafted, laid on grain. */
  readonly fitDrafted?: number;
  /** Fit of `rest` that the alignment search reached. */
  readonly fitSearch: number;
  /** Fit of `rest` under the final alignment. */
  readonly fitAligned: number;
  /** Fit of `shape` under the final alignment. */
  readonly fit: number;
  /**
   * Like `fit`, but only with symmetries of the print that bring the edges' directions together.
   */
  readonly fitStrict: number;
  /** Like `fit`, but with one symmetry of the print for the whole seam. */
  readonly fitSeam: number;
}

export interface Metrics extends Fits {
  /** Fits by the symmetries that do not mirror the print, if mirrored seams are forbidden. */
  readonly continuous?: Fits;
  /**
   * No alignment of `rest` costs less than this share of the found one's cost: 1 when it is proven
   * the best.
   */
  readonly searchBound: number;
  /**
   * Cost of the found alignment in the solver: `fitSearch` with the seams' weights and matches; 0
   * for other methods. [cm2]
   */
  readonly searchCost: number;
  readonly maxMovedCm: number;
  /**
   * Means by length over the seams that count. `worst` is the greatest mean of a seam of the
   * result; nine tenths of its seams have a mismatch of at most `p90`. [cm]
   */
  readonly localCm?: LocalMismatch & {readonly worst: number; readonly p90?: number};
  /** Length of seam with a mismatch above 5 mm. [cm] */
  readonly offCm?: number;
  /**
   * Cost by which answers to one problem compete: mismatch by visibility, and the visible length
   * that does not match. [cm2]
   */
  readonly answerCost?: number;
  /** Number of iterations of the deformation. */
  readonly iterations: number;
  /** Number of factorisations of sparse matrices, the costly part. */
  readonly factorisations: number;
  readonly milliseconds: Milliseconds;
  readonly method: Method;
  readonly seed: number;
  /** Effort of the search. Default 1. */
  readonly effort?: number;
}

/** Bound on alignments of the pieces as drafted: like `searchBound`, but computed for longer. */
export interface Proof {
  /**
   * No alignment of `rest` costs less than this share of the best found one's cost: 1 when that is
   * proven the best.
   */
  readonly bound: number;
  /** Cost of the best found alignment, as in the metrics of a result. [cm2] */
  readonly searchCost: number;
}

/**
 * Alternative places of all pieces: another design that matches about as well once its pieces are
 * shaped for it.
 */
export interface OtherAlignment {
  /** Alignments that give the other design when used as pins of a solve. */
  readonly pieces: readonly Alignment[];
  /** Mean mismatch of the pieces as drafted, and expected mean after shaping. [cm] */
  readonly placedCm: number;
  readonly expectedCm: number;
}

/** A solved pattern, as `seamwise-result/1`. Lengths in cm, angles in radians. */
export interface SolveResult {
  readonly format: 'seamwise-result/1';
  readonly units: 'cm';
  /**
   * `scale` and `turnDeg`: size and counter-clockwise turn of the print relative to its file, if
   * they differ from it. [1, degrees]
   */
  readonly print: {
    readonly group: GroupName;
    readonly w1: Point;
    readonly w2: Point;
    readonly scale?: number;
    readonly turnDeg?: number;
    /** The fabric for which the repeat is that after the wash. */
    readonly delivered?: Delivered;
  };
  /** Mirrored seams were forbidden: seams that would only match as a mirror image do not match. */
  readonly continuousOnly?: boolean;
  readonly pieces: readonly ResultPiece[];
  readonly seams: readonly ResultSeam[];
  /** The seams of a sewist, with their states; absent in results of earlier versions. */
  readonly seamGroups?: readonly SeamGroup[];
  readonly symmetries: readonly ResultSymmetry[];
  /** Lines that coincide without being sewn, as in a button front. */
  readonly matches?: readonly {readonly a: ResultMatchSide; readonly b: ResultMatchSide}[];
  /**
   * Size and body of the draft: the name of the size in its file, and measurements by name. [cm]
   */
  readonly size?: string;
  readonly body?: Readonly<Record<string, number>>;
  /**
   * Alignments of the pieces as drafted, laid on grain as if the print did not matter. With `rest`,
   * the state "before".
   */
  readonly drafted?: readonly Alignment[];
  /** Alignment of each piece at the end of the alignment search. */
  readonly search: readonly Alignment[];
  /** Other alignments, if requested; the best expected one comes first. */
  readonly otherAlignments?: readonly OtherAlignment[];
  readonly metrics: Metrics;
  /** Omissions and assumptions, one sentence each. */
  readonly notes: readonly string[];
  /** Codes and values of `notes`. */
  readonly noteDetails?: readonly NoteDetail[];
}

/** Data for drawing a garment: a result, or pieces and seams that are not solved yet. */
export type Pattern = Pick<
  SolveResult,
  'print' | 'continuousOnly' | 'pieces' | 'seams' | 'symmetries'
>;

/**
 * A piece as drafted and meshed: `shape` is `rest`, and it is laid on grain as if the print did not
 * matter.
 */
export interface MeshedPiece extends ResultPiece {
  /**
   * Per outline edge (from outline[k] to outline[k+1]), the number of the panel's edge in the file
   * that contains it.
   */
  readonly edges: readonly number[];
}

/** A garment before it is solved: no piece is shaped and no mismatch is measured yet. */
export interface MeshedPattern extends Pattern {
  readonly pieces: readonly MeshedPiece[];
  /** Mean fit over random alignments, as in the metrics of a result. [cm2] */
  readonly fitRandom: number;
  /** Omissions and assumptions so far, one sentence each. */
  readonly notes: readonly string[];
  readonly noteDetails?: readonly NoteDetail[];
}
