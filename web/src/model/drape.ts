/** A garment as it is worn: its pieces sewn to one cloth that lies on a form. */

/** The sizes of the form that the samples are drafted for. */
export const formSizes = ['XS', 'S', 'M', 'L', 'XL'] as const;
export type FormSize = (typeof formSizes)[number];

export const fabricNames = ['poplin', 'jersey', 'denim', 'chiffon'] as const;
export type FabricName = (typeof fabricNames)[number];

/** A piece meshed for the drape. Points are x, y after each other, in the coordinates of the result's piece. [cm] */
export interface DrapedPiece {
  readonly name: string;
  /** On the piece as drafted, and as cut. */
  readonly rest: Float64Array;
  readonly shape: Float64Array;
  /** Three vertices each, counter-clockwise seen on the face. */
  readonly triangles: Uint32Array;
  /** Per vertex its number in the cloth: those that seams join have the same. */
  readonly sewn: Uint32Array;
  /** Counter-clockwise. */
  readonly outline: Uint32Array;
  /** Per vertex of `outline` that of the result's piece at the same place. */
  readonly resultVertices: Uint32Array;
  /** Directions of the grain line. [rad] */
  readonly grainAngle: number;
  /** How many layers of the garment lie below it, by and large. */
  readonly layer: number;
  /** The part of the body it hangs on. */
  readonly part: BodyPart;
}

export const bodyParts = [
  'torso',
  'neck',
  'left arm',
  'right arm',
  'left leg',
  'right leg',
  'head',
] as const;
export type BodyPart = (typeof bodyParts)[number];

/** Vertices of one piece in sewing order. */
export interface DrapedSeamSide {
  readonly piece: number;
  readonly vertices: Uint32Array;
}

/** A surface in space: x, y, z after each other, y up, z to the front, the wearer's left +x. [cm] */
export interface Surface {
  readonly vertices: Float32Array;
  /** Three vertices each, counter-clockwise seen from outside. */
  readonly triangles: Uint32Array;
}

/** What moves when a garment is draped: first a coarse mesh, then a fine one. Pieces and seams are the result's, in its order. */
export interface DrapeMesh {
  readonly pieces: readonly DrapedPiece[];
  readonly seams: readonly {readonly a: DrapedSeamSide; readonly b: DrapedSeamSide}[];
  /** The symmetries that the drape keeps: vertex i of the first piece and image[i] of the second mirror each other in x = 0. */
  readonly mirrors: readonly {
    readonly pieces: readonly [number, number];
    readonly image: Uint32Array;
  }[];
  /** Of the cloth, in vertices. */
  readonly size: number;
}

export type DrapeStage = 'sew' | 'hang' | 'settle' | 'done';

export interface DrapeProgress {
  readonly stage: DrapeStage;
  /** 0 to 1 */
  readonly fraction: number;
}

/** What a drape did on one mesh. */
export interface StageReport {
  readonly name: DrapeStage;
  /** Of the cloth. */
  readonly vertices: number;
  readonly steps: number;
  /** In factorisations of the matrix of a grid of 90 x 90 nodes with 2 unknowns each. */
  readonly work: number;
  /** Before the first step and after each. [J] */
  readonly energy: readonly number[];
}

/** Of a quantity over all triangles. */
export interface Spread {
  readonly median: number;
  readonly p99: number;
  readonly max: number;
}

/** What was measured of a draped garment. */
export interface DrapeCheck {
  /** Between vertices that are sewn together. [cm] */
  readonly gap: number;
  /** Of the cloth in the form. [cm] */
  readonly depth: number;
  /** Largest stretch less 1, and 1 less the smallest. */
  readonly tension: Spread;
  readonly compression: Spread;
  /** Pairs of an edge and a triangle that it passes through. */
  readonly crossings: number;
  /** By the last step. [cm] */
  readonly moved: number;
}

/** Measurements of a body. [cm] */
export interface Measurements {
  /** Girths, taken with the tape level. */
  readonly bust: number;
  readonly waist: number;
  readonly hip: number;
  readonly neck: number;
  readonly head: number;
  readonly upperArm: number;
  readonly wrist: number;
  readonly thigh: number;
  readonly knee: number;
  readonly ankle: number;
  /** Between the two shoulder points, across the back. */
  readonly shoulderWidth: number;
  /** Between the two bust points. */
  readonly bustSpan: number;
  /** From the nape down to the waist. */
  readonly backLength: number;
  /** From the waist down to the fullest part of the hip, and to the knee. */
  readonly hipDepth: number;
  readonly kneeDepth: number;
  /** From the waist down to the seat of a chair: how deep the crotch lies. */
  readonly bodyRise: number;
  /** From the shoulder point down to the wrist. */
  readonly armLength: number;
  /** From the floor up to the waist. */
  readonly waistHeight: number;
}

/** What a cloth resists with; SI units. */
export interface Fabric {
  readonly name: FabricName;
  /** kg/m2 */
  readonly density: number;
  /** Of a sheet. [N/m] */
  readonly warp: number;
  readonly weft: number;
  readonly coupling: number;
  readonly shear: number;
  /** Tension beyond which warp and weft are so many times as stiff. */
  readonly stiffFrom: number;
  readonly stiffening: number;
  /** N m */
  readonly bendingWarp: number;
  readonly bendingWeft: number;
  readonly friction: number;
  /** Between the form and the middle of the cloth. [m] */
  readonly offset: number;
}

/** A section of a part of the form: u^2 + v^2 + square u^2 v^2 = 1, u = side / width, v = (ahead - middle) / depth. [cm] */
export interface FormSection {
  readonly level: number;
  readonly width: number;
  readonly depth: number;
  readonly middle: number;
  readonly square: number;
}

/** The form that a garment hangs on: a tailor's dummy. */
export interface Form {
  readonly body: Measurements;
  /** Sections along axes, joined in between. */
  readonly parts: readonly {
    readonly name: BodyPart;
    readonly origin: readonly [number, number, number];
    readonly up: readonly [number, number, number];
    readonly sections: readonly FormSection[];
  }[];
  /** Those parts that the garment covers. */
  readonly surface: Surface;
}

/** How to drape. */
export interface DrapeSettings {
  /** `poplin`, unless said otherwise. */
  readonly fabric?: FabricName;
  /** Of the form; unless said otherwise, that of the garment's file or the one that fits. */
  readonly size?: FormSize;
  /** A form by measurements, instead of by size. */
  readonly body?: Measurements;
  /** How much further it settles, 1 unless said otherwise. */
  readonly effort?: 1 | 2 | 4;
  /** An earlier drape of the same garment in another print: the cloth goes on from there. Of another garment or form it is of no matter. */
  readonly from?: Drape;
}

/** How to follow a drape and how to end it early. */
export interface DrapeHooks {
  readonly signal?: AbortSignal;
  /** What moves from now on, and the form it lies on; once for the coarse mesh, once for the fine one. */
  readonly onMesh?: (mesh: DrapeMesh) => void;
  readonly onForm?: (form: Form) => void;
  /** x, y, z per vertex of the cloth; at most each 33 ms. [cm] The array is the listener's own. */
  readonly onPositions?: (positions: Float32Array) => void;
  readonly onProgress?: (progress: DrapeProgress) => void;
}

/** A draped garment. */
export interface Drape {
  readonly mesh: DrapeMesh;
  /** x, y, z per vertex of the cloth. [cm] */
  readonly positions: Float64Array;
  readonly form: Form;
  readonly fabric: Fabric;
  readonly stages: readonly StageReport[];
  readonly check: DrapeCheck;
  /** What people should know, one sentence each. */
  readonly notes: readonly string[];
}
