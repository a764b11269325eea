/**
 * Writes a piece as entities of AAMA and ASTM DXF. Layers follow ANSI/AAMA-292 and ASTM D6673. Only
 * ASTM files contain validation copies of lines other than the boundary.
 */
import {
  degrees,
  distance,
  middle,
  minus,
  plus,
  towards,
  turnBetween,
  type Point,
} from '../../model/geometry/vectors.js';
import {signedArea} from '../../model/geometry/polyline.js';
import type {LaidPiece} from '../cut-sheet.js';
import {foldArrows} from '../../model/garment/fold-arrows.js';
import {foldLines, foldText} from '../../model/garment/folds.js';
import {lineColours} from '../line-colours.js';
import type {DxfFormat} from '../../model/base/dxf-format.js';
import {length, line, point, polyline, text, type Pair} from '../../files/dxf/records.js';

export const layers = {
  cut: 1,
  turn: 2,
  curve: 3,
  notch: 4,
  grain: 7,
  inner: 8,
  stripe: 9,
  plaid: 10,
  hole: 11,
  drill: 13,
  sew: 14,
  words: 15,
} as const;

/** The quality-validation copies of layers 1, 8, 11 and 14. */
const copies = {cut: 84, inner: 85, hole: 86, sew: 87} as const;

export interface PieceDxfOptions extends DxfFormat {
  /**
   * Writes the sewn line as the boundary on layer 1 and the cut line on layer 14, as CLO expects.
   * Default false.
   */
  readonly sewAsBoundary?: boolean;
}

/** Least turn of a corner. [rad] */
const cornerTurn = 0.35;
/** Points closer than this are equal. [cm] */
const same = 1e-3;
/** Half the length of an internal line that represents a tick. [cm] */
const tickReach = 0.4;

/** Corners of a line are turn points; all other points are curve points. */
function pointsOf(loop: readonly Point[], corners: readonly Point[]): readonly Pair[] {
  return loop.flatMap((p, k) => {
    const [before = p, after = p] = [loop.at(k - 1), loop[(k + 1) % loop.length]];
    const isCorner =
      Math.abs(turnBetween(minus(p, before), minus(after, p))) > cornerTurn ||
      corners.some((corner) => distance(corner, p) < same);
    return point(isCorner ? layers.turn : layers.curve, p);
  });
}

/** Greatest difference of the areas of equal lines. [cm2] */
const leastArea = 1e-6;

/** Returns whether the cut line differs from the sewn line. */
const hasAllowance = ({cut, sewn}: LaidPiece): boolean =>
  cut.length !== sewn.length ||
  cut.some((loop, k) => Math.abs(signedArea(loop) - signedArea(sewn[k] ?? [])) > leastArea);

/** The boundary, the other line, and cut-outs, with their validation copies. */
function outlines(
  piece: LaidPiece,
  {sewAsBoundary = false, style}: PieceDxfOptions,
): readonly Pair[] {
  const {cut, sewn, corners} = piece;
  const [boundary, other] = sewAsBoundary ? [sewn, cut] : [cut, sewn];
  const [ofCut, ofSewn] = [lineColours.cut.index, lineColours.sew.index];
  const [first, second] = sewAsBoundary ? [ofSewn, ofCut] : [ofCut, ofSewn];
  const [outer = [], ...holes] = boundary;
  const others = hasAllowance(piece) ? other : [];
  const drawn = (layer: 'cut' | 'hole' | 'sew', line: readonly Point[], colour: number) => [
    ...polyline(layers[layer], line, true, colour),
    ...pointsOf(line, corners),
    ...(layer === 'cut' || style === 'astm' ? polyline(copies[layer], line, true) : []),
  ];
  return [
    ...drawn('cut', outer, first),
    ...holes.flatMap((hole) => drawn('hole', hole, first)),
    ...others.flatMap((loop) => drawn('sew', loop, second)),
  ];
}

/** Notches on the boundary, with depth, width and direction into the piece. */
function notches(piece: LaidPiece, {sewAsBoundary = false}: PieceDxfOptions): readonly Pair[] {
  return piece.notches.flatMap(({at, angle, allowanceCm, depthCm}) =>
    point(layers.notch, sewAsBoundary ? at : plus(at, towards(angle), allowanceCm), [
      [30, length(Number(depthCm.toFixed(4)))],
      [39, 0],
      [50, Number(((degrees(angle) + 540) % 360).toFixed(3))],
    ]),
  );
}

/** All lines and points of a piece. */
export const drawn = (piece: LaidPiece, options: PieceDxfOptions = {}): readonly Pair[] => [
  ...outlines(piece, options),
  ...notches(piece, options),
  ...inside(piece, options),
];

function inside(piece: LaidPiece, {style}: PieceDxfOptions): readonly Pair[] {
  const {grain, internalLines, folds, ticks, stripe, plaid, drillHoles, matchPoints} = piece;
  return [
    ...line(layers.grain, grain),
    ...internalLines.flatMap((points) => [
      ...polyline(layers.inner, points, false),
      ...(style === 'astm' ? polyline(copies.inner, points, false) : []),
    ]),
    ...folds.flatMap((fold, k) => [
      ...foldLines(fold).flatMap((ends, part) => [
        ...line(layers.inner, ends),
        ...text(layers.words, middle(...ends), foldText(fold.kind, k + 1, part > 0)),
      ]),
      ...foldArrows(fold).flatMap((points) => polyline(layers.inner, points, false)),
    ]),
    ...ticks.flatMap(({at, angle, label}) => {
      const reach = towards(angle);
      return [
        ...line(layers.inner, [plus(at, reach, -tickReach), plus(at, reach, tickReach)]),
        ...text(layers.words, at, label),
      ];
    }),
    ...(stripe ? line(layers.stripe, stripe) : []),
    ...(plaid ? line(layers.plaid, plaid) : []),
    ...crosses(matchPoints),
    ...drillHoles.flatMap((at) => point(layers.drill, at)),
  ];
}

/** Numbered crosses. */
export const crosses = (points: LaidPiece['matchPoints']): readonly Pair[] =>
  points.flatMap(({at, number}) => [
    ...[0, Math.PI / 2].flatMap((angle) =>
      line(layers.inner, [
        plus(at, towards(angle), -tickReach),
        plus(at, towards(angle), tickReach),
      ]),
    ),
    ...text(layers.words, at, String(number)),
  ]);
