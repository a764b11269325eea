/** The drape: a garment's pieces sewn to one mesh on a form. */

/** Sizes of the form for which the samples are drafted. */
export const formSizes = ['XS', 'S', 'M', 'L', 'XL'] as const;
export type FormSize = (typeof formSizes)[number];

export const fabricNames = ['poplin', 'jersey', 'denim', 'chiffon'] as const;
export type FabricName = (typeof fabricNames)[number];

/**
 * A piece meshed for the drape. Points are flat x, y pairs in the coordinates of the result's
 * piece. [cm]
 */
export interface DrapedPiece {
  readonly name: string;
  /** Vertices on the piece as drafted, and as cut. */
  readonly rest: Float64Array;
  readonly shape: Float64Array;
  /** Three vertices per triangle, counter-clockwise as seen on the face. */
  readonly triangles: Uint32Array;
  /** Per vertex, its number in the sewn mesh; vertices joined by a seam have the same number. */
  readonly sewn: Uint32Array;
  /** Vertex numbers, counter-clockwise. */
  readonly outline: Uint32Array;
  /** Per vertex of `outline`, the vertex of the result's piece at the same place. */
  readonly resultVertices: Uint32Array;
  /** Direction of the grain line. [rad] */
  readonly grainAngle: number;
  /** Approximate number of layers of the garment below the piece. */
  readonly layer: number;
  /** Part of the body on which the piece hangs. */
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

/** A surface in space: flat x, y, z; y up, z to the front, the wearer's left +x. [cm] */
export interface Surface {
  readonly vertices: Float32Array;
  /** Three vertices per triangle, counter-clockwise as seen from outside. */
  readonly triangles: Uint32Array;
}

/**
 * The mesh that a drape moves: first a coarse one, then a fine one. Pieces and seams are those of
 * the result, in its order.
 */
export interface DrapeMesh {
  readonly pieces: readonly DrapedPiece[];
  readonly seams: readonly {readonly a: DrapedSeamSide; readonly b: DrapedSeamSide}[];
  /**
   * Symmetries that the drape keeps: vertex i of the first piece and image[i] of the second mirror
   * each other in x = 0.
   */
  readonly mirrors: readonly {
    readonly pieces: readonly [number, number];
    readonly image: Uint32Array;
  }[];
  /** Number of vertices of the sewn mesh. */
  readonly size: number;
}

export type DrapeStage = 'sew' | 'hang' | 'settle' | 'done';

export interface DrapeProgress {
  readonly stage: DrapeStage;
  /** Share of the work done, 0 to 1. */
  readonly fraction: number;
}

/** Report of a drape on one mesh. */
export interface StageReport {
  readonly name: DrapeStage;
  /** Number of vertices of the sewn mesh. */
  readonly vertices: number;
  readonly steps: number;
  /** Work in factorisations of the matrix of a grid of 90 x 90 nodes with 2 unknowns each. */
  readonly work: number;
  /** Energy before the first step and after each step. [J] */
  readonly energy: readonly number[];
}

/** Distribution of a quantity over all triangles. */
export interface Spread {
  readonly median: number;
  readonly p99: number;
  readonly max: number;
}

/** Measurements of a draped garment. */
export interface DrapeCheck {
  /**
   * Gap between vertices that are sewn together: always 0, because a seam joins both sides in one
   * vertex. [cm]
   */
  readonly gap: number;
  /** Greatest depth of the fabric inside the form. [cm] */
  readonly depth: number;
  /** Largest principal stretch - 1, and 1 - smallest principal stretch. */
  readonly tension: Spread;
  readonly compression: Spread;
  /** Pairs of an edge and a triangle that the edge crosses. */
  readonly crossings: number;
  /** Greatest movement of a vertex in the last step. [cm] */
  readonly moved: number;
  /**
   * Upper estimate of the distance of the vertices from rest, root mean square, extrapolated from
   * the last steps; not in files of earlier versions. [cm]
   */
  readonly fromRest?: number;
  /** True if `fromRest` is at most 0.5 cm; files of earlier versions lack it. */
  readonly atRest?: boolean;
}

/** Body measurements. [cm] */
export interface Measurements {
  /** Girths, measured with the tape level. */
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
  /** Distance between the shoulder points, across the back. */
  readonly shoulderWidth: number;
  /** Distance between the bust points. */
  readonly bustSpan: number;
  /** Length from the nape down to the waist. */
  readonly backLength: number;
  /** Lengths from the waist down to the fullest part of the hip, and to the knee. */
  readonly hipDepth: number;
  readonly kneeDepth: number;
  /** Length from the waist down to the seat of a chair, which is the depth of the crotch. */
  readonly bodyRise: number;
  /** Length from the shoulder point down to the wrist. */
  readonly armLength: number;
  /** Height from the floor to the waist. */
  readonly waistHeight: number;
}

/** Mechanical properties of a fabric, in SI units. */
export interface Fabric {
  readonly name: FabricName;
  /** Mass per area. [kg/m2] */
  readonly density: number;
  /** Membrane stiffness of a sheet. [N/m] */
  readonly warp: number;
  readonly weft: number;
  readonly coupling: number;
  readonly shear: number;
  /** Tension above which warp and weft are `stiffening` times as stiff. */
  readonly stiffFrom: number;
  readonly stiffening: number;
  /** Bending stiffness. [N m] */
  readonly bendingWarp: number;
  readonly bendingWeft: number;
  readonly friction: number;
  /** Distance from the form to the middle of the fabric. [m] */
  readonly offset: number;
}

/**
 * A section of a part of the form: u^2 + v^2 + square u^2 v^2 = 1, u = side / width, v = (ahead -
 * middle) / depth. [cm]
 */
export interface FormSection {
  readonly level: number;
  readonly width: number;
  readonly depth: number;
  readonly middle: number;
  readonly square: number;
}

/** The dress form on which a garment hangs. */
export interface Form {
  readonly body: Measurements;
  /** Sections along axes; the surface joins them. */
  readonly parts: readonly {
    readonly name: BodyPart;
    readonly origin: readonly [number, number, number];
    readonly up: readonly [number, number, number];
    readonly sections: readonly FormSection[];
  }[];
  /** Surface of the parts that the garment covers. */
  readonly surface: Surface;
}

/** Settings of a drape. */
export interface DrapeSettings {
  /** Default `poplin`. */
  readonly fabric?: FabricName;
  /** Size of the form. Default: the size in the garment's file, or the one that fits. */
  readonly size?: FormSize;
  /** A form by body measurements instead of by size. */
  readonly body?: Measurements;
  /** Multiplies the accuracy and the limit of steps of the settling. Default 1. */
  readonly effort?: 1 | 2 | 4;
  /**
   * An earlier drape of the same garment in another print, from which the mesh continues. A drape
   * of another garment or form has no effect.
   */
  readonly from?: Drape;
}

/** Callbacks to follow a drape, and a signal to end it early. */
export interface DrapeHooks {
  readonly signal?: AbortSignal;
  /**
   * Receives the mesh that moves from now on, first the coarse one, then the fine one. `onForm`
   * receives the form.
   */
  readonly onMesh?: (mesh: DrapeMesh) => void;
  readonly onForm?: (form: Form) => void;
  /**
   * Receives x, y, z per vertex of the mesh, at most every 33 ms. [cm] The callback owns the array.
   */
  readonly onPositions?: (positions: Float32Array) => void;
  readonly onProgress?: (progress: DrapeProgress) => void;
}

/**
 * Codes of notes on a drape. They are part of the API: new ones may be added, but none may change.
 */
export type DrapeNoteCode =
  | 'drapeNoStart'
  /** The garment still moves by `number` in a step. [cm] */
  | 'drapeMoving'
  /** Only in drapes of earlier versions: the fabric would be stretched by the share `number`. */
  | 'drapeStretched'
  /** Only in drapes of earlier versions: the form comes through the fabric by `number`. [cm] */
  | 'drapeForm'
  /** The fabric passes through itself at `number` places. */
  | 'drapeCrossings'
  /** The pieces hang by their seams and names, since the file has no placements. */
  | 'drapeBySeams';

export interface DrapeNote {
  readonly code: DrapeNoteCode;
  readonly number: number;
}

/** A draped garment. */
export interface Drape {
  readonly mesh: DrapeMesh;
  /** Coordinates x, y, z per vertex of the mesh. [cm] */
  readonly positions: Float64Array;
  readonly form: Form;
  readonly fabric: Fabric;
  readonly stages: readonly StageReport[];
  readonly check: DrapeCheck;
  /** Notes for people, one sentence each. */
  readonly notes: readonly string[];
  /** Content of each note, for translation; missing in stored drapes. */
  readonly noteDetails?: readonly DrapeNote[];
}
