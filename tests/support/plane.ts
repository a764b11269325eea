/** Geometry for the checks of results, in addition to that of the sources. */
import {cross, minus, plus, rotated, type Alignment, type Point} from '@/model/geometry/vectors.js';

export const scale = (a: Point, s: number): Point => [a[0] * s, a[1] * s];

/** Eq. 3: p' = R F p + t with F = diag(-1, 1). */
export const mirrored = ({angle, translation}: Alignment, [x, y]: Point): Point =>
  plus(rotated([-x, y], angle), translation);

/** The element at `index`, which must exist; negative indices count from the end. */
export function at<T>(list: ArrayLike<T>, index: number): T {
  const value = list[index < 0 ? list.length + index : index];
  if (value === undefined) throw new RangeError(`no element ${index} of ${list.length}`);
  return value;
}

/** Each element with its successor around the loop. */
export const aroundLoop = <T>(loop: readonly T[]): [T, T][] =>
  loop.map((v, k) => [v, at(loop, (k + 1) % loop.length)]);

/** Each element with its successor along the line. */
export const alongLine = <T>(line: readonly T[]): [T, T][] =>
  line.slice(1).map((v, k) => [at(line, k), v]);

export const sum = (values: readonly number[]): number => values.reduce((s, v) => s + v, 0);
/** The greatest value; 0 for an empty list, unlike Math.max. */
export const greatest = (values: readonly number[]): number =>
  values.reduce((m, v) => Math.max(m, v), 0);

/** The distance from a point to a polyline. Without arrays, since the checks measure millions. */
export function toLine([x, y]: Point, line: readonly Point[]): number {
  let least = Infinity;
  for (let k = 1; k < line.length; k++) {
    const [[ax, ay], [bx, by]] = [at(line, k - 1), at(line, k)];
    const [wx, wy, px, py] = [bx - ax, by - ay, x - ax, y - ay];
    const share = Math.max(0, Math.min(1, (px * wx + py * wy) / (wx * wx + wy * wy || 1)));
    const [dx, dy] = [px - share * wx, py - share * wy];
    least = Math.min(least, dx * dx + dy * dy);
  }
  return Math.sqrt(least);
}

/**
 * Returns whether two of the segments cross in their insides; neighbours, which share an end, never
 * do.
 */
export function crossesItself(lines: readonly (readonly [Point, Point])[]): boolean {
  const side = (a: Point, b: Point, c: Point) => cross(minus(b, a), minus(c, a));
  type Segment = readonly [Point, Point];
  // Boxes separate segments far apart on one line, regardless of rounding errors in areas.
  const meet = ([a, b]: Segment, [c, d]: Segment, axis: 0 | 1) =>
    Math.max(a[axis], b[axis]) >= Math.min(c[axis], d[axis]) &&
    Math.max(c[axis], d[axis]) >= Math.min(a[axis], b[axis]);
  const cut = ([a, b]: Segment, [c, d]: Segment) =>
    meet([a, b], [c, d], 0) &&
    meet([a, b], [c, d], 1) &&
    side(a, b, c) * side(a, b, d) < 0 &&
    side(c, d, a) * side(c, d, b) < 0;
  return lines.some((line, k) => lines.slice(k + 1).some((other) => cut(line, other)));
}
