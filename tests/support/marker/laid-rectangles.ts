/** Garments of rectangles, and their layouts made by hand. Lengths in cm. */
import {
  minus,
  onPiece,
  plus,
  rotated,
  type Alignment,
  type Point,
} from '@/model/geometry/vectors.js';
import type {LaidPlacement, LayPlan} from '@/model/result/marker-plan.js';
import type {Print} from '@/model/print/repeating-print.js';
import type {ResultPiece, SolveResult} from '@/model/result/result.js';
import {at, sum} from '../plane.js';
import {extentOf, ringArea} from './rings.js';
import {plainMetrics, squarePiece} from '../garments/two-squares.js';

const allowance = 1;

const corners = (width: number, height: number, more = 0): readonly Point[] => [
  [-more, -more],
  [width + more, -more],
  [width + more, height + more],
  [-more, height + more],
];

/** A rectangle with its lower left corner at the origin and its grain upright. */
export const rectangle = (
  name: string,
  width: number,
  height: number,
  alignment: Alignment = {angle: 0, translation: [0, 0]},
): ResultPiece => {
  const shape = corners(width, height);
  return squarePiece(name, {rest: shape, shape, alignment, grainAngle: Math.PI / 2});
};

export const resultOf = (
  {group, w1, w2}: Print,
  pieces: readonly ResultPiece[],
  more: Partial<SolveResult> = {},
): SolveResult => ({
  ...{format: 'seamwise-result/1', units: 'cm', print: {group, w1, w2}, pieces, seams: []},
  ...{symmetries: [], metrics: plainMetrics, notes: [], search: []},
  ...more,
});

/** Place of a piece after a turn of the print about its origin and so many repeats. */
interface Lying {
  readonly piece: number;
  readonly result?: number;
  readonly copy?: number;
  /** [rad] */
  readonly turn?: number;
  readonly repeats: Point;
  /** Shift of the print under the piece, before its turn. */
  readonly shift?: Point;
}

export function placementOf(
  results: readonly SolveResult[],
  origin: Point,
  {piece, result = 0, copy = 0, turn = 0, repeats: [i, j], shift = [0, 0]}: Lying,
): LaidPlacement {
  const {print, pieces} = at(results, result);
  const {name, shape, alignment} = at(pieces, piece);
  const [width, height] = at(shape, 2);
  const moved = plus([i * print.w1[0], i * print.w1[1]], print.w2, j);
  const place = {
    angle: turn - alignment.angle,
    translation: plus(
      plus(origin, moved),
      rotated(minus(shift, rotated(alignment.translation, -alignment.angle)), turn),
    ),
  };
  const cut = corners(width, height, allowance).map((p) => onPiece(place, p));
  return {result, copy, piece: name, ...place, cut};
}

/** A plan with consistent figures for these placements. */
export function planOf(
  results: readonly SolveResult[],
  placements: readonly LaidPlacement[],
  more: Partial<LayPlan> = {},
): LayPlan {
  const {widthCm = 60, printOrigin = null} = more;
  const [, lower, , upper] = extentOf(placements.flatMap(({cut}) => cut));
  const lengthCm = upper - lower;
  return {
    ...{format: 'seamwise-layplan/1', print: at(results, 0).print, widthCm, printOrigin},
    ...{selvedgeCm: 1, gapCm: 0.2, allowanceCm: allowance, lengthCm, placements, unplaced: []},
    useShare: sum(placements.map(({cut}) => ringArea(cut))) / (widthCm * lengthCm),
    ...{
      boundCm: lengthCm,
      proven: true,
      freeLengthCm: null,
      widths: [],
      cheaper: [],
      notes: [],
      noteDetails: [],
    },
    phases: printOrigin ? [{phaseCm: printOrigin[0], lengthCm}] : [],
    ...more,
  };
}
