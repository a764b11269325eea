/**
 * A garment as one document, whatever its file format. The core reads and checks the file once; all
 * other code uses the document. Lengths are in centimetres, y up; pieces lie face up and their
 * outlines run counter-clockwise.
 */
import type {Point} from '../geometry/vectors.js';
import type {GrainChoice, GrainLock} from './grain.js';
import type {Symmetry} from './symmetries.js';

/** Members of the file that this program does not know, unchanged. */
export interface Unknown {
  readonly more?: Readonly<Record<string, unknown>>;
}

/**
 * Shape of an allowance at its corners. `miter`: both lines are extended until they meet; `mirror`:
 * the adjacent cutting line continues as its mirror image, as for a hem that is turned up;
 * `square`: a right angle.
 */
export type AllowanceCorner = 'miter' | 'mirror' | 'square';

/** Fabric beyond the sewing line of a piece. */
export interface Allowance {
  /** Width, 0 to 20. [cm] */
  readonly width: number;
  readonly corner?: AllowanceCorner;
}

/** An edge of an outline as drafted; the next one begins where it ends. */
export interface DraftedEdge extends Unknown {
  /**
   * Ends, and between them the control points of a Bezier curve: one, two, or none for a line or an
   * arc. A path is a chain of n >= 2 cubics: the control points of each and the points where they
   * meet, 3 n + 1 in all. [cm]
   */
  readonly points: readonly [Point, Point, ...Point[]];
  /** Radius of a circular arc. [cm] */
  readonly radius?: number;
  /** Angle of a circular arc, positive counter-clockwise. [rad] */
  readonly sweep?: number;
  readonly label?: string;
  /** Seam allowance beyond the edge. */
  readonly allowance?: Allowance;
  /** The user has marked the edge as not sewn, such as a hem or a neckline. */
  readonly open?: true;
}

/** A mark on an edge of the outline. */
export interface DraftedNotch {
  /** Number of the edge. */
  readonly edge: number;
  /** Position as a share of the edge's length, from its start. */
  readonly at: number;
}

/**
 * Place of a piece on the body: x to the wearer's left, y up, z to the front; turned about x, then
 * y, then z.
 */
export interface Placement {
  /** [cm] */
  readonly translation: readonly [x: number, y: number, z: number];
  /** No rotation when omitted. [degrees] */
  readonly rotation?: readonly [x: number, y: number, z: number];
}

/** Kinds of folds; `roll` and `press` are creases, which hide no fabric. */
export const foldKinds = ['knife', 'box', 'inverted', 'tuck', 'roll', 'press'] as const;
export type FoldKind = (typeof foldKinds)[number];

/**
 * A pleat, a tuck or a crease. A pleat is closed by laying `line` on `to`; the fabric between the
 * lines is hidden then. Both lines run in the same direction.
 */
export interface DraftedFold extends Unknown {
  readonly line: readonly [Point, Point];
  /** A crease may have no second line. */
  readonly to?: readonly [Point, Point];
  readonly kind: FoldKind;
}

export interface GarmentPiece extends Unknown {
  /** Name in designs, options and results. */
  readonly name: string;
  /** Name shown to the user. */
  readonly label?: string;
  /** True if the file shows the back of the piece, where x is reversed. */
  readonly mirroredFromInput: boolean;
  readonly outline: readonly DraftedEdge[];
  /** Cut-outs, clockwise. */
  readonly holes: readonly (readonly DraftedEdge[])[];
  /** Lines drawn on the piece, neither cut nor sewn: darts, folds, pocket positions. */
  readonly internalLines: readonly (readonly Point[])[];
  /** Cutting line and sewing line, where they differ from the outline. */
  readonly cutLine?: readonly Point[];
  readonly sewLine?: readonly Point[];
  readonly notches?: readonly DraftedNotch[];
  readonly folds?: readonly DraftedFold[];
  /** Points marked by drilling. */
  readonly drillHoles?: readonly Point[];
  readonly grain?: {
    readonly line?: readonly [Point, Point];
    readonly lock?: GrainLock;
    readonly toleranceDeg?: number;
  };
  /** All grain lines that the maker draws, if there are several; the user chooses one. */
  readonly grains?: readonly GrainChoice[];
  readonly placement?: Placement;
  /** Number of copies to cut. Default 1. */
  readonly quantity?: number;
  readonly size?: string;
  readonly material?: string;
}

/** One edge of a piece, both by number. */
export interface EdgeOfPiece {
  readonly piece: number;
  readonly edge: number;
}

/**
 * Two edges sewn to each other. Its number is its index in the list, and that of the stitch in the
 * file.
 */
export interface GarmentSeam extends Unknown {
  readonly a: EdgeOfPiece;
  readonly b: EdgeOfPiece;
  /** Start meets start; otherwise the start of one edge meets the end of the other. */
  readonly sameDirection: boolean;
  readonly weight: number;
  readonly matched: boolean;
  /** Name shown to the user. */
  readonly name?: string;
  /** Ratio stated in the file; the lengths of the edges take precedence. */
  readonly lengthRatio?: number;
  /** A program has proposed the seam, and the user has not confirmed it. */
  readonly suggested?: true;
}

/** Two marked lines that coincide without being sewn. */
export interface GarmentMatch extends Unknown {
  readonly a: {readonly piece: string; readonly line: readonly Point[]};
  readonly b: {readonly piece: string; readonly line: readonly Point[]};
  readonly weight?: number;
  readonly name?: string;
}

/** Number of units in a metre. */
export const unitsInMetre = {cm: 100, mm: 1000, inch: 100 / 2.54, m: 1} as const;
export type FileUnit = keyof typeof unitsInMetre;

/** A question to the user: the garment is not wearable in the assumed unit. */
export interface UnitsQuestion {
  readonly about: 'units';
  readonly tallestCm: number;
  /** Units in which the garment is wearable. */
  readonly likely: readonly FileUnit[];
}

export type GarmentQuestion = UnitsQuestion;

export interface GarmentDocument extends Unknown {
  readonly pieces: readonly GarmentPiece[];
  readonly seams: readonly GarmentSeam[];
  readonly matches: readonly GarmentMatch[];
  /** Axes refer to pieces that lie face up, too. */
  readonly symmetries: readonly Symmetry[];
  readonly title?: string;
  readonly size?: string;
  /** Names of pieces for the user, by the names of the pieces. */
  readonly names?: Readonly<Record<string, unknown>>;
  /** Unknown members of the file's `pattern` and `properties`. */
  readonly morePattern?: Readonly<Record<string, unknown>>;
  readonly moreProperties?: Readonly<Record<string, unknown>>;
  readonly questions: readonly GarmentQuestion[];
}
