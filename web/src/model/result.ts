import type {Alignment, MirrorMap, Point} from './geometry.js';
import type {NoteDetail} from './notes.js';
import type {GroupName} from './print.js';
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
  /** The file showed the back of the panel: x was negated. */
  readonly mirroredFromInput: boolean;
  /** Direction of the grain line. [rad] */
  readonly grainAngle?: number;
  /** Where the input panel hangs: turned about the fixed axes x, then y, then z [rad], then shifted [cm]. */
  readonly placement?: {
    readonly translation: readonly [number, number, number];
    readonly rotation: readonly [number, number, number];
  };
}

/** A line on a piece; with another it lies on another piece without being sewn. [cm] */
export interface ResultMatchSide {
  readonly piece: number;
  /** On the piece as drafted, face side up. */
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
  /** False: sewn, but the user switched the match off. */
  readonly matched: boolean;
  /** Rest length of side a / rest length of side b. */
  readonly lengthRatio: number;
  /** Whether the print continues across the seam or is mirrored at it. */
  readonly kind: 'continuous' | 'mirrored';
  /** Print mismatch per seam edge, by the one symmetry of the print that carries the whole seam: it shows where the print runs off. [cm] */
  readonly mismatch: readonly number[];
  /** The mean of that. [cm] */
  readonly whole?: number;
  readonly local?: LocalMismatch;
  /** `drafted`: shaping has left the seam as it was. */
  readonly line?: 'shaped' | 'drafted';
  /** Why the seam stays above 3 mm; absent where it does not. */
  readonly why?: SeamReason;
}

/** Mean mismatch along a seam point by point, each under the allowed symmetry of the print that suits it. [cm] */
export interface LocalMismatch {
  /** Of the pieces as drafted, laid on grain. */
  readonly drafted: number;
  /** Of the pieces as drafted, under the final alignment. */
  readonly placed: number;
  /** Of the result. */
  readonly final: number;
}

/**
 * Why a print does not meet at a seam: the `grain` of its pieces runs across each other; one side is gathered; the
 * print's `group` has no mirror for it; the repeat's `size`; what `others` of the garment ask for; it is `locked`.
 */
export type SeamReason = 'grain' | 'gather' | 'group' | 'size' | 'others' | 'locked';

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
  /** Of the last attempt, where a method makes several with growing weights. */
  readonly deformation: number;
  /** Both phases, and reading, meshing and measuring around them. */
  readonly total: number;
}

/** Sums of edge length times print mismatch over the seams that count. [cm2] */
export interface Fits {
  /** Mean over random alignments of `rest`. */
  readonly fitRandom: number;
  /** Of the pieces as drafted, laid on grain. */
  readonly fitDrafted?: number;
  /** What the alignment search reached on `rest`. */
  readonly fitSearch: number;
  /** Fit of `rest` under the final alignment. */
  readonly fitAligned: number;
  /** Fit of `shape` under the final alignment. */
  readonly fit: number;
  /** As `fit`, but only with symmetries of the print that bring the edges' directions together. */
  readonly fitStrict: number;
  /** As `fit`, but with one symmetry of the print for the whole seam. */
  readonly fitSeam: number;
}

export interface Metrics extends Fits {
  /** Where mirrored seams are forbidden: the fits by those symmetries of the print that do not mirror it. */
  readonly continuous?: Fits;
  /** No alignment of `rest` costs less than this share of the one found: 1 when it is proven the best. */
  readonly searchBound: number;
  /** What that one costs the solver: `fitSearch` with the seams' weights and matches; 0 of other methods. [cm2] */
  readonly searchCost: number;
  readonly maxMovedCm: number;
  /**
   * By length over the seams that count; `worst` is the greatest mean of a seam of the result, and nine tenths of its
   * seams miss by no more than `p90`. [cm]
   */
  readonly localCm?: LocalMismatch & {readonly worst: number; readonly p90?: number};
  /** How much seam misses by more than 5 mm. [cm] */
  readonly offCm?: number;
  /** Of the deformation. */
  readonly iterations: number;
  /** Of sparse matrices, the costly part. */
  readonly factorisations: number;
  readonly milliseconds: Milliseconds;
  readonly method: Method;
  readonly seed: number;
}

/** How good alignments of the pieces as drafted can be: what `searchBound` says, looked into for longer. */
export interface Proof {
  /** No alignment of `rest` costs less than this share of the best one found: 1 when that is proven the best. */
  readonly bound: number;
  /** Of the best one found, as in the metrics of a result. [cm2] */
  readonly searchCost: number;
}

/** Where all pieces may lie instead: another design that fits about as well, once its pieces are shaped for it. */
export interface OtherAlignment {
  /** As pins of a solve they are that design. */
  readonly pieces: readonly Alignment[];
  /** Mean mismatch of the pieces as drafted, and what shaping is expected to leave of it. [cm] */
  readonly placedCm: number;
  readonly expectedCm: number;
}

/** A solved pattern, as `seamwise-result/1`. Lengths in cm, angles in radians. */
export interface SolveResult {
  readonly format: 'seamwise-result/1';
  readonly units: 'cm';
  readonly print: {readonly group: GroupName; readonly w1: Point; readonly w2: Point};
  /** Mirrored seams were forbidden: what would meet as a mirror image does not. */
  readonly continuousOnly?: boolean;
  readonly pieces: readonly ResultPiece[];
  readonly seams: readonly ResultSeam[];
  readonly symmetries: readonly ResultSymmetry[];
  /** What lies on each other without being sewn, as a button front does. */
  readonly matches?: readonly {readonly a: ResultMatchSide; readonly b: ResultMatchSide}[];
  /** Whom the garment is drafted for: as its file calls the size, and measurements by name. [cm] */
  readonly size?: string;
  readonly body?: Readonly<Record<string, number>>;
  /** The pieces as drafted, laid on grain as one would cut them without a thought for the print: with `rest`, what "before" means. */
  readonly drafted?: readonly Alignment[];
  /** Each piece's alignment when the alignment search ended. */
  readonly search: readonly Alignment[];
  /** Where they were asked for: what is expected to fit best first. */
  readonly otherAlignments?: readonly OtherAlignment[];
  readonly metrics: Metrics;
  /** What was dropped or assumed, one sentence each. */
  readonly notes: readonly string[];
  /** What each of them says, as code and values. */
  readonly noteDetails?: readonly NoteDetail[];
}

/** What there is to draw of a garment: of a result, or of pieces and seams that are not solved yet. */
export type Pattern = Pick<
  SolveResult,
  'print' | 'continuousOnly' | 'pieces' | 'seams' | 'symmetries'
>;

/** A piece as drafted and meshed: `shape` is `rest`, and it lies on grain as one would cut it without a thought for the print. */
export interface MeshedPiece extends ResultPiece {
  /** Per outline edge (from outline[k] to outline[k+1]): the number of the panel's edge in the file that it is part of. */
  readonly edges: readonly number[];
}

/** A garment before it is solved: no piece is shaped, no mismatch is measured yet. */
export interface MeshedPattern extends Pattern {
  readonly pieces: readonly MeshedPiece[];
  /** As in the metrics of a result. [cm2] */
  readonly fitRandom: number;
  /** What was dropped or assumed so far, one sentence each. */
  readonly notes: readonly string[];
  readonly noteDetails?: readonly NoteDetail[];
}
