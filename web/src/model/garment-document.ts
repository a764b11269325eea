/**
 * A garment as one document, whatever file it came from: the core reads and checks the file, once, and everybody else
 * looks at this. Lengths are in centimetres, y up; pieces lie face side up and their outlines run counter-clockwise.
 */
import type {Point} from './geometry.js';
import type {GrainLock} from './options.js';
import type {Symmetry} from './symmetries.js';

/** Members of the file that this program does not know, as they are. */
export interface Unknown {
  readonly more?: Readonly<Record<string, unknown>>;
}

/** How an allowance ends at its corners: both lines run on until they meet, as its mirror image, or at a right angle. */
export type AllowanceCorner = 'miter' | 'mirror' | 'square';

/** Cloth beyond the line along which a piece is sewn. */
export interface Allowance {
  /** From 0 to 20. [cm] */
  readonly width: number;
  readonly corner?: AllowanceCorner;
}

/** An edge of an outline as drafted; the next one begins where it ends. */
export interface DraftedEdge extends Unknown {
  /**
   * Its ends, and between them the control points of a Bezier curve: one, two, or none of a line or an arc. Of a path,
   * a chain of cubics, those of each, with the points where they meet: 3 n + 1 of n cubics, n >= 2. [cm]
   */
  readonly points: readonly [Point, Point, ...Point[]];
  /** Radius of a circular arc. [cm] */
  readonly radius?: number;
  /** Angle that a circular arc turns by, counter-clockwise if positive. [rad] */
  readonly sweep?: number;
  readonly label?: string;
  /** What is cut beyond it. */
  readonly allowance?: Allowance;
  /** Its owner says that it is sewn to nothing, such as a hem or a neckline. */
  readonly open?: true;
}

/** A mark on an edge of the outline. */
export interface DraftedNotch {
  /** The number of the edge. */
  readonly edge: number;
  /** A share of its length, from its start. */
  readonly at: number;
}

/** Where a piece hangs on the body: x to the wearer's left, y up, z to the front; turned about x, then y, then z. */
export interface Placement {
  /** [cm] */
  readonly translation: readonly [x: number, y: number, z: number];
  /** [degrees] None when left out. */
  readonly rotation?: readonly [x: number, y: number, z: number];
}

export interface GarmentPiece extends Unknown {
  /** The name that designs, options and results use. */
  readonly name: string;
  /** What people call it. */
  readonly label?: string;
  /** Whether the file shows its back: x is the other way round there. */
  readonly mirroredFromInput: boolean;
  readonly outline: readonly DraftedEdge[];
  /** Cut-outs, clockwise. */
  readonly holes: readonly (readonly DraftedEdge[])[];
  /** Drawn on the piece, neither cut nor sewn: darts, folds, places of pockets. */
  readonly internalLines: readonly (readonly Point[])[];
  /** Where the cloth is cut, and sewn, if not at the outline. */
  readonly cutLine?: readonly Point[];
  readonly sewLine?: readonly Point[];
  readonly notches?: readonly DraftedNotch[];
  /** Places that are drilled to mark them. */
  readonly drillHoles?: readonly Point[];
  readonly grain?: {
    readonly line?: readonly [Point, Point];
    readonly lock?: GrainLock;
    readonly toleranceDeg?: number;
  };
  readonly placement?: Placement;
  /** How many are cut. Default 1. */
  readonly quantity?: number;
  readonly size?: string;
  readonly material?: string;
}

/** One edge of a piece, both by number. */
export interface EdgeOfPiece {
  readonly piece: number;
  readonly edge: number;
}

/** Two edges that are sewn to each other. Its number is its place in the list, and that of the stitch in the file. */
export interface GarmentSeam extends Unknown {
  readonly a: EdgeOfPiece;
  readonly b: EdgeOfPiece;
  /** Start meets start; otherwise the start of one edge meets the end of the other. */
  readonly sameDirection: boolean;
  readonly weight: number;
  readonly matched: boolean;
  /** What people call it. */
  readonly name?: string;
  /** As the file states it; the edges decide. */
  readonly lengthRatio?: number;
  /** A program has proposed it, and nobody confirmed it. */
  readonly suggested?: true;
}

/** Two marked lines that lie on each other without being sewn. */
export interface GarmentMatch {
  readonly a: {readonly piece: string; readonly line: readonly Point[]};
  readonly b: {readonly piece: string; readonly line: readonly Point[]};
  readonly weight?: number;
  readonly name?: string;
}

/** What makes a metre. */
export const unitsInMetre = {cm: 100, mm: 1000, inch: 100 / 2.54, m: 1} as const;
export type FileUnit = keyof typeof unitsInMetre;

/** What a file leaves open, for its owner to answer: in the unit that it is taken in, nobody could wear the garment. */
export interface UnitsQuestion {
  readonly about: 'units';
  readonly tallestCm: number;
  /** Units in which somebody could. */
  readonly likely: readonly FileUnit[];
}

export type GarmentQuestion = UnitsQuestion;

export interface GarmentDocument extends Unknown {
  readonly pieces: readonly GarmentPiece[];
  readonly seams: readonly GarmentSeam[];
  readonly matches: readonly GarmentMatch[];
  /** Axes, too, are those of pieces that lie face up. */
  readonly symmetries: readonly Symmetry[];
  readonly title?: string;
  readonly size?: string;
  /** What pieces are called, by their names. */
  readonly names?: Readonly<Record<string, unknown>>;
  /** Of the file's `pattern` and `properties`, what this program does not know. */
  readonly morePattern?: Readonly<Record<string, unknown>>;
  readonly moreProperties?: Readonly<Record<string, unknown>>;
  readonly questions: readonly GarmentQuestion[];
}
