/** Lines through points, open or closed. Lengths in cm. */
import {between, cross, distance, dot, minus, nearestShare, unit, type Point} from './vectors.js';

/** Length of the line through points. */
export const lengthOf = (line: readonly Point[]): number =>
  line.reduce((sum, to, k) => sum + distance(line[k - 1] ?? to, to), 0);

/** Area within a closed line, positive when the line runs counter-clockwise. [cm2] */
export const signedArea = (loop: readonly Point[]): number =>
  loop.reduce((sum, from, k) => sum + cross(from, loop[(k + 1) % loop.length] ?? from), 0) / 2;

/** Position at a share of a line's length, from 0 to 1: the step, and the part of that step. */
export function stepAt(
  line: readonly Point[],
  share: number,
): {readonly step: number; readonly part: number} {
  const lengths = line.slice(1).map((to, k) => distance(line[k] ?? to, to));
  let left = share * lengths.reduce((sum, length) => sum + length, 0);
  let step = 0;
  while (step < lengths.length - 1 && left > (lengths[step] ?? 0)) left -= lengths[step++] ?? 0;
  const length = lengths[step] ?? 0;
  return {step, part: length > 0 ? Math.min(1, left / length) : 0};
}

/** A point of a line, and the direction of the line at this point. */
export interface OnLine {
  readonly at: Point;
  /** Unit vector. */
  readonly along: Point;
}

/** The point at a share of a line's length, from 0 to 1. */
export function atShare(line: readonly Point[], share: number): OnLine {
  const {step, part} = stepAt(line, share);
  const from = line[step] ?? [0, 0];
  const to = line[step + 1] ?? [from[0] + 1, from[1]];
  return {at: between(from, to, part), along: unit(minus(to, from))};
}

/**
 * Crossings of an endless line with a closed one, as distances along it from its point `through`,
 * in no order.
 */
export function crossingsOf(loop: readonly Point[], through: Point, along: Point): number[] {
  const seen = loop.map((p) => minus(p, through));
  return seen.flatMap((a, k) => {
    const b = seen[(k + 1) % seen.length] ?? a;
    const [from, to] = [cross(a, along), cross(b, along)];
    return from < 0 === to < 0 ? [] : [dot(between(a, b, from / (from - to)), along)];
  });
}

/**
 * Returns whether the segment between two points crosses the ray from a third point to the right.
 */
const crossesRay = ([ax, ay]: Point, [bx, by]: Point, [x, y]: Point): boolean =>
  ay > y !== by > y && x < ax + ((y - ay) / (by - ay)) * (bx - ax);

/** Returns whether a closed line encloses a point. */
export const isInside = (loop: readonly Point[], point: Point): boolean =>
  loop.reduce(
    (odd, from, k) => crossesRay(from, loop[(k + 1) % loop.length] ?? from, point) !== odd,
    false,
  );

/** An upright box, from its lower left corner to its upper right one. */
export interface Box {
  readonly low: Point;
  readonly high: Point;
}

/** The smallest box around points. */
export function boxOf(points: readonly Point[]): Box {
  let [left, lower, right, upper] = [Infinity, Infinity, -Infinity, -Infinity];
  for (const [x, y] of points) {
    [left, right] = [Math.min(left, x), Math.max(right, x)];
    [lower, upper] = [Math.min(lower, y), Math.max(upper, y)];
  }
  return {low: [left, lower], high: [right, upper]};
}

/** Distance from a point to a closed line. */
export function distanceTo(loop: readonly Point[], p: Point): number {
  let nearest = Infinity;
  loop.forEach((a, k) => {
    const b = loop[(k + 1) % loop.length] ?? a;
    nearest = Math.min(nearest, distance(p, between(a, b, nearestShare(a, b, p))));
  });
  return nearest;
}

/** Stretches of a straight line within a closed one and outside its holes. */
export function linesInside(
  loops: readonly (readonly Point[])[],
  from: Point,
  to: Point,
): readonly (readonly [Point, Point])[] {
  const length = distance(from, to);
  const along = unit(minus(to, from));
  const stops = loops
    .flatMap((loop) => crossingsOf(loop, from, along))
    .filter((at) => at > 0 && at < length)
    .sort((a, b) => a - b);
  const ends = [0, ...stops, length].map((at) => between(from, to, at / length));
  return ends.slice(1).flatMap((end, k) => {
    const start = ends[k] ?? end;
    const half = between(start, end, 0.5);
    const isWithin = loops.filter((loop) => isInside(loop, half)).length % 2 === 1;
    return isWithin ? [[start, end] as const] : [];
  });
}
