/** Tests of the distance between closed lines. Lengths in cm. */
import {between, distance, minus, plus, type Point} from '../model/geometry/vectors.js';
import {boxOf, distanceTo, isInside, type Box} from '../model/geometry/polyline.js';

/** Smallest distance that counts as a gap. [cm] */
const slack = 1e-3;
/** Height of the horizontal bands that index the edges of a line. [cm] */
const bandHeight = 2;
/** Grid cells per side of the box, in the search for an inner point. */
const tries = 10; // even, so that the grid includes the middle

/** A closed line whose edges are indexed by height. */
export interface Ring extends Box {
  readonly points: readonly Point[];
  /** A point well inside the line. */
  readonly inner: Point;
  /** Indices of the edges that reach into each band, from the lowest band up. */
  readonly bands: readonly (readonly number[])[];
}

const band = (ring: Pick<Ring, 'low'>, y: number): number =>
  Math.floor((y - ring.low[1]) / bandHeight);

/**
 * Penalty per cm of distance from the middle: it decides between grid points of equal clearance.
 */
const pull = 0.05;

/**
 * Largest number of points used to measure a clearance, which need not be exact to the millimetre.
 */
const mostTold = 64;

/** The grid point inside the line with the greatest clearance. */
function innerOf(all: readonly Point[], {low, high}: Box): Point {
  const every = Math.ceil(all.length / mostTold);
  const points = all.filter((_, k) => k % every === 0);
  const middle = between(low, high, 0.5);
  let [best, room]: [Point, number] = [points[0] ?? low, -Infinity];
  for (let i = 1; i < tries; i++) {
    for (let j = 1; j < tries; j++) {
      const at: Point = [
        low[0] + ((high[0] - low[0]) * i) / tries,
        low[1] + ((high[1] - low[1]) * j) / tries,
      ];
      if (!isInside(points, at)) continue;
      const apart = distanceTo(points, at) - pull * distance(at, middle);
      if (apart > room && isInside(all, at)) [best, room] = [at, apart];
    }
  }
  return best;
}

export function ringOf(points: readonly Point[]): Ring {
  const box = boxOf(points);
  const bands = Array.from({length: band(box, box.high[1]) + 1}, (): number[] => []);
  points.forEach((from, k) => {
    const to = points[(k + 1) % points.length] ?? from;
    const last = band(box, Math.max(from[1], to[1]));
    for (let b = band(box, Math.min(from[1], to[1])); b <= last; b++) bands[b]?.push(k);
  });
  let inner: Point | undefined;
  return {
    ...{...box, points, bands},
    get inner() {
      return (inner ??= innerOf(points, box)); // computed only on demand
    },
  };
}

/** Squared distance of a point from an edge. */
function offEdge(px: number, py: number, ax: number, ay: number, bx: number, by: number): number {
  const [dx, dy] = [bx - ax, by - ay];
  const length = dx * dx + dy * dy;
  const way = length > 0 ? ((px - ax) * dx + (py - ay) * dy) / length : 0;
  const share = way < 0 ? 0 : way > 1 ? 1 : way;
  const [x, y] = [px - ax - share * dx, py - ay - share * dy];
  return x * x + y * y;
}

/** Signed distance of a point from the line through a and b. */
function sideOf(px: number, py: number, ax: number, ay: number, bx: number, by: number): number {
  const [dx, dy] = [bx - ax, by - ay];
  const length = Math.sqrt(dx * dx + dy * dy) || 1;
  return (dx * (py - ay) - dy * (px - ax)) / length;
}

const areOpposite = (one: number, other: number): boolean =>
  (one > slack && other < -slack) || (one < -slack && other > slack);

/** Returns whether two edges cross, or come closer than the square root of `least`. */
function meet(a: Point, b: Point, c: Point, d: Point, least: number): boolean {
  const [[ax, ay], [bx, by], [cx, cy], [dx, dy]] = [a, b, c, d];
  if (
    least > 0 &&
    (offEdge(ax, ay, cx, cy, dx, dy) < least ||
      offEdge(bx, by, cx, cy, dx, dy) < least ||
      offEdge(cx, cy, ax, ay, bx, by) < least ||
      offEdge(dx, dy, ax, ay, bx, by) < least)
  )
    return true;
  return (
    areOpposite(sideOf(ax, ay, cx, cy, dx, dy), sideOf(bx, by, cx, cy, dx, dy)) &&
    areOpposite(sideOf(cx, cy, ax, ay, bx, by), sideOf(dx, dy, ax, ay, bx, by))
  );
}

/** Returns whether an edge meets any nearby edge of a ring. */
function meetsRing(from: Point, to: Point, ring: Ring, near: number, least: number): boolean {
  const [left, right] = from[0] < to[0] ? [from[0], to[0]] : [to[0], from[0]];
  const [lower, upper] = from[1] < to[1] ? [from[1], to[1]] : [to[1], from[1]];
  if (left > ring.high[0] + near || right < ring.low[0] - near) return false;
  const last = Math.min(ring.bands.length - 1, band(ring, upper + near));
  for (let b = Math.max(0, band(ring, lower - near)); b <= last; b++) {
    for (const k of ring.bands[b] ?? []) {
      const c = ring.points[k];
      const d = ring.points[k + 1] ?? ring.points[0];
      if (!c || !d) continue;
      const isOff =
        (c[0] < left - near && d[0] < left - near) || (c[0] > right + near && d[0] > right + near);
      if (!isOff && meet(from, to, c, d, least)) return true;
    }
  }
  return false;
}

/**
 * Returns whether two rings are disjoint and at least `gap` apart.
 * @param shift translation of the second ring
 */
export function areApart(one: Ring, other: Ring, shift: Point, gap: number): boolean {
  const near = Math.max(0, gap - slack);
  for (const axis of [0, 1] as const) {
    if (one.low[axis] > other.high[axis] + shift[axis] + near) return true;
    if (other.low[axis] + shift[axis] > one.high[axis] + near) return true;
  }
  const [few, many] = one.points.length < other.points.length ? [one, other] : [other, one];
  const moved = few === other ? shift : minus([0, 0], shift);
  const {points} = few;
  let from = plus(points.at(-1) ?? [0, 0], moved);
  for (const point of points) {
    const to: Point = [point[0] + moved[0], point[1] + moved[1]];
    if (meetsRing(from, to, many, near, near * near)) return false;
    from = to;
  }
  return (
    !isInside(many.points, plus(few.inner, moved)) && !isInside(points, minus(many.inner, moved))
  );
}
