/** Positions of symmetry marks on a piece. Lengths in cm, y up. */
import {
  dot,
  middle,
  minus,
  plus,
  radians,
  rotated,
  towards,
  type MirrorMap,
  type Point,
} from '../model/geometry/vectors.js';
import {grainAt} from '../model/garment/grain.js';
import {boxOf, isInside} from '../model/geometry/polyline.js';
import type {PanelMarks} from '../model/garment/panel-marks.js';
import type {ResultPiece} from '../model/result/result.js';

export const pick = (points: readonly Point[], vertices: readonly number[]): Point[] =>
  vertices.flatMap((v) => points.slice(v, v + 1));

/**
 * The mirror axis along the given points, extended by `overhang`. p' = R F p + t mirrors in a line
 * through t / 2.
 */
export function axisAlong(
  {angle, translation}: MirrorMap,
  points: readonly Point[],
  overhang: number,
): readonly [Point, Point] {
  const direction: Point = [-Math.sin(angle / 2), Math.cos(angle / 2)];
  const onAxis = middle([0, 0], translation);
  const along = points.map((p) => dot(minus(p, onAxis), direction));
  const at = (s: number): Point => plus(onAxis, direction, s);
  return [at(Math.min(...along) - overhang), at(Math.max(...along) + overhang)];
}

/** The mirror image p' = R F p + t of a point. */
export const mirrorImage = ({angle, translation}: MirrorMap, [x, y]: Point): Point =>
  plus(rotated([-x, y], angle), translation);

/**
 * The point of a piece with the greatest distance from its outline and obstacles, on a coarse grid,
 * and that distance.
 */
export function innermost(
  points: readonly Point[],
  obstacles: readonly Point[] = [],
): {readonly at: Point; readonly room: number} {
  const {low, high} = boxOf(points);
  let at = middle(low, high);
  let room = 0;
  const n = 24;
  const inTheWay = [...points, ...obstacles];
  for (let i = 1; i < n; i++) {
    for (let j = 1; j < n; j++) {
      const p: Point = [
        low[0] + ((high[0] - low[0]) * i) / n,
        low[1] + ((high[1] - low[1]) * j) / n,
      ];
      const free = clearance(inTheWay, p, room);
      if (free > room + 1e-6 && isInside(points, p)) [at, room] = [p, free];
    }
  }
  return {at, room};
}

/** The distance from a point to the nearest of others; 0 if it is at most `least`. */
function clearance(points: readonly Point[], [px, py]: Point, least: number): number {
  let nearest = Infinity;
  for (const [x, y] of points) {
    nearest = Math.min(nearest, (x - px) ** 2 + (y - py) ** 2);
    if (nearest <= least * least) return 0;
  }
  return Math.sqrt(nearest);
}

// Position of a piece's grain line. Lengths in cm.

/** Greatest length of a line that the file does not draw. */
const greatest = 20;

type Drafted = Pick<ResultPiece, 'rest' | 'outline'>;

/**
 * A line in the widest part of the drafted piece.
 * @param angle from its x axis, face up [radians]
 */
export function lineAt({rest, outline}: Drafted, angle: number): readonly [Point, Point] {
  const {at, room} = innermost(pick(rest, outline));
  const reach = Math.min(greatest / 2, 0.8 * room);
  return [plus(at, towards(angle), -reach), plus(at, towards(angle), reach)];
}

/**
 * The grain line of a drafted piece, face up: the user's, otherwise the garment's; undefined
 * without either.
 */
export function grainLine(
  piece: Drafted,
  {grain, grainDeg}: Pick<PanelMarks, 'grain' | 'grainDeg'> = {},
): readonly [Point, Point] | undefined {
  const isDrawn = grain !== undefined && grainAt([{line: grain}], grainDeg ?? NaN) !== undefined;
  return grainDeg === undefined || isDrawn ? grain : lineAt(piece, radians(grainDeg));
}
