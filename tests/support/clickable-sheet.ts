import type {Sheet, SheetPiece} from '@/clicks/sheet.js';
import {plus, type Point} from '@/model/geometry/vectors.js';
import type {SeamSide} from '@/model/result/result.js';

export interface DrawnPiece extends Partial<Omit<SheetPiece, 'outline' | 'holes'>> {
  /** Counter-clockwise; its points come first. */
  readonly loop: readonly Point[];
  readonly cutOut?: readonly Point[];
  readonly mirroredFromInput?: boolean;
  /** Default: equal to the displayed shape. */
  readonly rest?: readonly Point[];
}

/** The piece, and its vertices in sewing order. */
type End = readonly [piece: number, ...vertices: number[]];

const side = ([piece, ...vertices]: End): SeamSide => ({piece, vertices});

/** Pieces named piece_0, piece_1, ..., at the origin unless they have an offset. */
export function sheetOf(
  drawn: readonly DrawnPiece[],
  seams: readonly (readonly [End, End])[] = [],
): Sheet {
  const pieces = drawn.map(({loop, cutOut = [], ...more}, k): SheetPiece => ({
    name: `piece_${k}`,
    label: `Piece ${k}`,
    points: [...loop, ...cutOut],
    triangles: [],
    outline: loop.map((_, v) => v),
    holes: cutOut.length > 0 ? [cutOut.map((_, v) => loop.length + v)] : [],
    offset: [0, 0],
    ...more,
  }));
  return {
    pieces,
    seams: seams.map(([a, b]) => ({a: side(a), b: side(b)})),
    pattern: {
      pieces: drawn.map(({rest, mirroredFromInput = false}, k) => ({
        rest: rest ?? pieces[k]?.points ?? [],
        mirroredFromInput,
      })),
    },
  };
}

/** A rectangle with its lower left corner at the origin; a vertex at each corner. */
export const rectangle = (width: number, height: number): readonly Point[] => [
  [0, 0],
  [width, 0],
  [width, height],
  [0, height],
];

/** A square of 8 cm with a wedge of 2 x 4 cm cut into it from above. */
export const dartedLoop: readonly Point[] = [
  [0, 0],
  [8, 0],
  [8, 8],
  [5, 8],
  [4, 4],
  [3, 8],
  [0, 8],
];

/** The square of `dartedLoop`; its legs, edges 3 and 4, are sewn to each other from the tip. */
export const dartedSquare = (): Sheet =>
  sheetOf(
    [{loop: dartedLoop, edges: [0, 1, 2, 3, 4, 5, 6]}],
    [
      [
        [0, 4, 3],
        [0, 4, 5],
      ],
    ],
  );

/**
 * Two squares of 4 cm, the second 10 cm to the right. The right side of the first is sewn to the
 * left side of the second, both upwards. The file's edges: 2 below, then 3, 0 and 1
 * counter-clockwise.
 */
export const sewnSquares = (more: Partial<DrawnPiece> = {}): Sheet =>
  sheetOf(
    [
      {loop: rectangle(4, 4), edges: [2, 3, 0, 1], ...more},
      {loop: rectangle(4, 4), edges: [2, 3, 0, 1], offset: [10, 0]},
    ],
    [
      [
        [0, 1, 2],
        [1, 0, 3],
      ],
    ],
  );

/** Number of vertices in the outline of a round piece. */
const roundSides = 200;

const roundAt = (k: number): Point => [45 * (k % 8), 45 * Math.floor(k / 8)];

const onCircle = (share: number): Point => [
  20 * Math.cos(2 * Math.PI * share),
  20 * Math.sin(2 * Math.PI * share),
];

/** Round pieces in rows of eight, each of four edges and sewn to the next one. */
export function manyRounds(count: number): Sheet {
  const loop = Array.from({length: roundSides}, (_, k) => onCircle(k / roundSides));
  const quarter = roundSides / 4;
  const edges = loop.map((_, k) => Math.floor(k / quarter));
  const vertices = Array.from({length: quarter + 1}, (_, k) => k);
  return sheetOf(
    Array.from({length: count}, (_, k) => ({loop, edges, offset: roundAt(k)})),
    Array.from({length: count - 1}, (_, k) => [
      [k, ...vertices],
      [k + 1, ...vertices.map((v) => v + quarter)],
    ]),
  );
}

/** Points on the outlines of these pieces, spread over all of them. */
export const pressesOn = (pieces: number, count: number): Point[] =>
  Array.from({length: count}, (_, k) => plus(roundAt(k % pieces), onCircle(k / count)));
