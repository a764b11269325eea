/** Whether closed lines keep a distance from each other. Lengths in cm. */
import {between, distance, minus, plus, type Point} from '../model/geometry.js';
import {boxOf, distanceTo, isInside, type Box} from '../model/polyline.js';

/** What is nearer by less than this touches. */
const slack = 1e-3;
/** Of the bands across a line by which its edges are found. */
const bandHeight = 2;
/** Points that are tried for being well inside, per side of the box. */
const tries = 10; // the middle is one of them

/** A closed line with its edges in order of height. */
export interface Ring extends Box {
  readonly points: readonly Point[];
  /** Well inside of it. */
  readonly inner: Point;
  /** Numbers of the edges that reach into each band, from the lowest. */
  readonly bands: readonly (readonly number[])[];
}

const band = (ring: Pick<Ring, 'low'>, y: number): number =>
  Math.floor((y - ring.low[1]) / bandHeight);

/** Of two points of a grid with as much room, the one nearer to the middle is taken: a share of how far it is. */
const pull = 0.05;

/** How far a point is inside is told by so many points of the line, at the most: it is no matter of millimetres. */
const mostTold = 64;

/** The point of a grid that is furthest from the line, inside of it. */
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
      return (inner ??= innerOf(points, box)); // sought only where somebody asks
    },
  };
}

/** Of a point from an edge, squared. */
function offEdge(px: number, py: number, ax: number, ay: number, bx: number, by: number): number {
  const [dx, dy] = [bx - ax, by - ay];
  const length = dx * dx + dy * dy;
  const way = length > 0 ? ((px - ax) * dx + (py - ay) * dy) / length : 0;
  const share = way < 0 ? 0 : way > 1 ? 1 : way;
  const [x, y] = [px - ax - share * dx, py - ay - share * dy];
  return x * x + y * y;
}

/** On which side of a line through a, b a point is, and how far. */
function sideOf(px: number, py: number, ax: number, ay: number, bx: number, by: number): number {
  const [dx, dy] = [bx - ax, by - ay];
  const length = Math.sqrt(dx * dx + dy * dy) || 1;
  return (dx * (py - ay) - dy * (px - ax)) / length;
}

const areOpposite = (one: number, other: number): boolean =>
  (one > slack && other < -slack) || (one < -slack && other > slack);

/** Whether two edges cross, or come nearer than the root of `least`. */
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

/** Whether an edge meets any of a ring that is near enough. */
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
 * Whether neither of two rings holds any of the other, nor comes nearer to it than `gap`.
 * @param shift moves the second one before
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
