/** Closed lines for the checks of layouts: their distances and overlaps. Lengths in cm. */
import {Clipper, FillRule} from 'clipper2-ts';

import {cross, minus, plus, type Point} from '@/model/geometry/vectors.js';
import {aroundLoop, at, greatest} from '../plane.js';

export type Ring = readonly Point[];

/** Signed area, positive if the ring runs counter-clockwise. [cm2] */
export const ringArea = (ring: Ring): number =>
  aroundLoop(ring).reduce((sum, [p, q]) => sum + cross(p, q), 0) / 2;

export const movedBy = (ring: Ring, by: Point): Ring => ring.map((p) => plus(p, by));

/** Left, lower, right and upper end. */
type Extent = readonly [left: number, lower: number, right: number, upper: number];

export function extentOf(points: Ring): Extent {
  const [x, y] = [points.map((p) => p[0]), points.map((p) => p[1])];
  return [Math.min(...x), Math.min(...y), Math.max(...x), Math.max(...y)];
}

export function holds(ring: Ring, [x, y]: Point): boolean {
  let isIn = false;
  for (const [[ax, ay], [bx, by]] of aroundLoop(ring)) {
    if (ay > y !== by > y && x < ax + ((y - ay) / (by - ay)) * (bx - ax)) isIn = !isIn;
  }
  return isIn;
}

interface Segment {
  readonly from: Point;
  readonly to: Point;
  readonly extent: Extent;
}

/** A ring with precomputed parts for repeated measurements. */
export interface Outline {
  readonly ring: Ring;
  readonly extent: Extent;
  readonly segments: readonly Segment[];
}

export const outlineOf = (ring: Ring): Outline => ({
  ring,
  extent: extentOf(ring),
  segments: aroundLoop(ring).map(([from, to]) => ({from, to, extent: extentOf([from, to])})),
});

/** Lower bound of the distance; 0 if they share a column and a row. */
const extentGap = (a: Extent, b: Extent, [dx, dy]: Point): number =>
  Math.hypot(
    Math.max(0, a[0] - b[2] - dx, b[0] + dx - a[2]),
    Math.max(0, a[1] - b[3] - dy, b[1] + dy - a[3]),
  );

/**
 * Square of the distance from a point to a segment. Without arrays, since the checks measure
 * millions.
 */
function squareToSegment([x, y]: Point, [ax, ay]: Point, [bx, by]: Point): number {
  const [wx, wy, px, py] = [bx - ax, by - ay, x - ax, y - ay];
  const share = Math.max(0, Math.min(1, (px * wx + py * wy) / (wx * wx + wy * wy || 1)));
  const [dx, dy] = [px - share * wx, py - share * wy];
  return dx * dx + dy * dy;
}

const toSegment = (p: Point, a: Point, b: Point): number => Math.sqrt(squareToSegment(p, a, b));

/** Distance from a point to a closed line. */
export function toRing(p: Point, ring: Ring): number {
  let least = Infinity;
  let from = at(ring, -1);
  for (const to of ring) {
    least = Math.min(least, squareToSegment(p, from, to));
    from = to;
  }
  return Math.sqrt(least);
}

function betweenSegments(a: Point, b: Point, c: Point, d: Point): number {
  const [ab, cd] = [minus(b, a), minus(d, c)];
  const doCross =
    cross(ab, minus(c, a)) * cross(ab, minus(d, a)) < 0 &&
    cross(cd, minus(a, c)) * cross(cd, minus(b, c)) < 0;
  if (doCross) return 0;
  return Math.min(toSegment(a, c, d), toSegment(b, c, d), toSegment(c, a, b), toSegment(d, a, b));
}

/**
 * Distance between a ring and a shifted one; 0 if they cross, or one contains the other.
 * @param enough  any distance below it may be returned instead
 */
export function ringDistance(
  a: Outline,
  b: Outline,
  shift: Point = [0, 0],
  {enough = 0, most = Infinity} = {},
): number {
  let least = most;
  if (extentGap(a.extent, b.extent, shift) >= least) return least;
  for (const one of a.segments) {
    if (extentGap(one.extent, b.extent, shift) >= least) continue;
    for (const other of b.segments) {
      if (extentGap(one.extent, other.extent, shift) >= least) continue;
      const [c, d] = [plus(other.from, shift), plus(other.to, shift)];
      least = Math.min(least, betweenSegments(one.from, one.to, c, d));
      if (least <= enough) return least;
    }
  }
  const back: Point = [-shift[0], -shift[1]];
  const isHeld =
    holds(a.ring, plus(at(b.ring, 0), shift)) || holds(b.ring, plus(at(a.ring, 0), back));
  return isHeld ? 0 : least;
}

/** Area that two rings share, by clipping. [cm2] */
export function sharedArea(a: Ring, b: Ring): number {
  const [p, q] = [a, b].map((ring) => [ring.map(([x, y]) => ({x, y}))]);
  const common = Clipper.intersectD(p ?? [], q ?? [], FillRule.NonZero, 6);
  return Math.abs(
    common
      .map((path) => ringArea(path.map(({x, y}): Point => [x, y])))
      .reduce((sum, area) => sum + area, 0),
  );
}

/**
 * Greatest distance between the points of a ring and those of another one, which should be equal.
 */
export const ringsApart = (a: Ring, b: Ring): number =>
  a.length === b.length ? greatest(a.map((p, k) => Math.hypot(...minus(p, at(b, k))))) : Infinity;
