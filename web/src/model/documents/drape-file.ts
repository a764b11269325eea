/** A draped garment as a file with everything needed to repeat its measurements. */
import type {
  BodyPart,
  Drape,
  DrapeCheck,
  DrapedPiece,
  DrapeSettings,
  Fabric,
  FormSection,
  Measurements,
  StageReport,
} from '../result/draped-garment.js';
import type {Point} from '../geometry/vectors.js';
import type {SolveResult} from '../result/result.js';

/** Coordinates x, y, z: y up, z to the front, the wearer's left +x. [cm] */
export type Place = readonly [x: number, y: number, z: number];

export type Corners = readonly [number, number, number];

export interface DrapeFilePiece {
  readonly name: string;
  /** Vertices on the piece as drafted and as cut, in the coordinates of the result. [cm] */
  readonly rest: readonly Point[];
  readonly shape: readonly Point[];
  /** Counter-clockwise as seen on the face. */
  readonly triangles: readonly Corners[];
  readonly positions: readonly Place[];
  /** Vertex numbers, counter-clockwise. */
  readonly outline: readonly number[];
  /** Per vertex of `outline`, the vertex of the result's piece at the same place. */
  readonly resultVertices: readonly number[];
  /** Number of layers of the garment below the piece. */
  readonly layer: number;
  /** Direction of the grain line. [rad] */
  readonly grainAngle: number;
  readonly part: BodyPart;
}

/** Vertices of one piece in sewing order. */
export interface DrapeFileSide {
  readonly piece: number;
  readonly vertices: readonly number[];
}

export interface DrapeFileSeam {
  readonly a: DrapeFileSide;
  readonly b: DrapeFileSide;
  /** Number of the seam in the result. */
  readonly stitch: number;
}

/** Vertex i of the first piece and image[i] of the second mirror each other in x = 0. */
export interface DrapeFileMirror {
  readonly pieces: readonly [number, number];
  readonly image: readonly number[];
}

export interface DrapeFileForm {
  readonly body: Measurements;
  /** Sections at levels along an axis; the form is smooth between them. [cm] */
  readonly parts: readonly {
    readonly name: BodyPart;
    readonly origin: Place;
    readonly up: Place;
    readonly sections: readonly FormSection[];
  }[];
  /**
   * Closed surface of the parts that the garment covers, counter-clockwise as seen from outside.
   */
  readonly vertices: readonly Place[];
  readonly triangles: readonly Corners[];
}

/**
 * A draped garment as `seamwise-drape/1`. Lengths in cm, to 1e-4; angles in radians; energies in J.
 */
export interface DrapeFile {
  readonly format: 'seamwise-drape/1';
  readonly units: 'cm';
  readonly pieces: readonly DrapeFilePiece[];
  readonly seams: readonly DrapeFileSeam[];
  readonly mirrors: readonly DrapeFileMirror[];
  /** Lines held on each other without a seam, such as a button front: the matches of the result. */
  readonly holds: NonNullable<SolveResult['matches']>;
  readonly form: DrapeFileForm;
  /** SI units. */
  readonly fabric: Fabric;
  /** Distance from the form to the middle of the fabric. [cm] */
  readonly contactOffset: number;
  readonly effort: NonNullable<DrapeSettings['effort']>;
  readonly stages: readonly StageReport[];
  readonly check: DrapeCheck;
  /** Notes for people, one sentence each. */
  readonly notes: readonly string[];
  /** Duration of draping; 0 where equal drapes have to give equal bytes. */
  readonly metrics: {readonly milliseconds: number};
}

/**
 * Converts a drape to a file.
 * @param result the draped result
 * @param milliseconds duration of draping; 0 by default, so that equal drapes give equal files
 */
export function drapeFile(
  {matches = []}: Pick<SolveResult, 'matches'>,
  {mesh, positions, form, fabric, stages, check, notes}: Drape,
  {effort = 1}: DrapeSettings = {},
  milliseconds = 0,
): DrapeFile {
  return {
    ...{format: 'seamwise-drape/1', units: 'cm'},
    pieces: mesh.pieces.map((piece) => filed(piece, positions)),
    seams: mesh.seams.map(({a, b}, stitch) => ({
      a: {piece: a.piece, vertices: [...a.vertices]},
      b: {piece: b.piece, vertices: [...b.vertices]},
      stitch,
    })),
    mirrors: mesh.mirrors.map(({pieces, image}) => ({pieces, image: [...image]})),
    holds: matches,
    form: {
      ...{body: form.body, parts: form.parts},
      vertices: triples(form.surface.vertices, rounded),
      triangles: triples(form.surface.triangles),
    },
    fabric,
    contactOffset: rounded(100 * fabric.offset),
    effort,
    ...{stages, check, notes},
    metrics: {milliseconds},
  };
}

export const drapeText = (file: DrapeFile): string => `${JSON.stringify(file)}\n`;

const filed = (piece: DrapedPiece, positions: Float64Array): DrapeFilePiece => ({
  name: piece.name,
  rest: pairs(piece.rest),
  shape: pairs(piece.shape),
  triangles: triples(piece.triangles),
  positions: Array.from(piece.sewn, (vertex) =>
    triple(positions.subarray(3 * vertex, 3 * vertex + 3), 0, rounded),
  ),
  outline: [...piece.outline],
  resultVertices: [...piece.resultVertices],
  ...{layer: piece.layer, grainAngle: piece.grainAngle, part: piece.part},
});

/** Rounds to 1e-4, symmetrically about 0, so that mirror images stay mirror images. */
const rounded = (value: number): number =>
  (Math.sign(value) * Math.round(1e4 * Math.abs(value))) / 1e4 + 0; // no -0

const pairs = (numbers: Float64Array): readonly Point[] =>
  Array.from({length: numbers.length / 2}, (_, k) => [
    rounded(numbers[2 * k] ?? 0),
    rounded(numbers[2 * k + 1] ?? 0),
  ]);

const same = (value: number): number => value;

const triples = (numbers: ArrayLike<number>, each = same): readonly Place[] =>
  Array.from({length: numbers.length / 3}, (_, k) => triple(numbers, 3 * k, each));

const triple = (numbers: ArrayLike<number>, at: number, each: (value: number) => number): Place => [
  each(numbers[at] ?? 0),
  each(numbers[at + 1] ?? 0),
  each(numbers[at + 2] ?? 0),
];
