/** Axis-aligned boxes on a sheet, and their intersections with outlines. Lengths in cm. */
import {cross, minus, type Point} from '../model/geometry/vectors.js';
import {isInside, type Box} from '../model/geometry/polyline.js';

export const boxAt = ([x, y]: Point, width: number, height: number): Box => ({
  low: [x, y],
  high: [x + width, y + height],
});

export const grown = ({low, high}: Box, by: number): Box => ({
  low: [low[0] - by, low[1] - by],
  high: [high[0] + by, high[1] + by],
});

/** The intersection of two boxes; for disjoint boxes, a box with its corners swapped. */
export const shared = (a: Box, b: Box): Box => ({
  low: [Math.max(a.low[0], b.low[0]), Math.max(a.low[1], b.low[1])],
  high: [Math.min(a.high[0], b.high[0]), Math.min(a.high[1], b.high[1])],
});

export function overlap(a: Box, b: Box): boolean {
  const {low, high} = shared(a, b);
  return low[0] < high[0] && low[1] < high[1];
}

export const cornersOf = ({low, high}: Box): readonly [Point, Point, Point, Point] => [
  low,
  [high[0], low[1]],
  high,
  [low[0], high[1]],
];

/** Returns whether a line segment meets a box. */
function enters(from: Point, to: Point, box: Box): boolean {
  const {low, high} = box;
  const isBeside = ([0, 1] as const).some(
    (axis) =>
      Math.max(from[axis], to[axis]) < low[axis] || Math.min(from[axis], to[axis]) > high[axis],
  );
  if (isBeside) return false;
  const sides = cornersOf(box).map((corner) => cross(minus(to, from), minus(corner, from)));
  return Math.min(...sides) <= 0 && Math.max(...sides) >= 0;
}

/** Returns whether a closed line meets a box. */
export const crossesInto = (loop: readonly Point[], box: Box): boolean =>
  loop.some((p, k) => enters(p, loop[(k + 1) % loop.length] ?? p, box));

/** Returns whether the region within an outline and its holes meets a box. */
export const reachesInto = (loops: readonly (readonly Point[])[], box: Box): boolean =>
  loops.some((loop) => crossesInto(loop, box)) ||
  loops.filter((loop) => isInside(loop, box.low)).length % 2 === 1;
