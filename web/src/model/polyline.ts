/** Lines through points, open or closed. Lengths in cm. */
import {between, cross, distance, dot, minus, nearestShare, unit, type Point} from './geometry.js';

/** The length of the line through points. */
export const lengthOf = (line: readonly Point[]): number =>
  line.slice(1).reduce((sum, to, k) => sum + distance(line[k] ?? to, to), 0);

/** The area within a closed line, positive when that runs counter-clockwise. [cm2] */
export const signedArea = (loop: readonly Point[]): number =>
  loop.reduce((sum, from, k) => sum + cross(from, loop[(k + 1) % loop.length] ?? from), 0) / 2;

/** Where on a line a share of its length lies behind, from 0 to 1: in which step, and at what part of that. */
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

/** A point of a line, and the direction in which the line runs there. */
export interface OnLine {
  readonly at: Point;
  /** Of length 1. */
  readonly along: Point;
}

/** Where on a line its length has been gone by this share, from 0 to 1. */
export function atShare(line: readonly Point[], share: number): OnLine {
  const {step, part} = stepAt(line, share);
  const from = line[step] ?? [0, 0];
  const to = line[step + 1] ?? [from[0] + 1, from[1]];
  return {at: between(from, to, part), along: unit(minus(to, from))};
}

/** Where an endless line crosses a closed one, in no order: how far along it from its point `through`. */
export function crossingsOf(loop: readonly Point[], through: Point, along: Point): number[] {
  const seen = loop.map((p) => minus(p, through));
  return seen.flatMap((a, k) => {
    const b = seen[(k + 1) % seen.length] ?? a;
    const [from, to] = [cross(a, along), cross(b, along)];
    return from < 0 === to < 0 ? [] : [dot(between(a, b, from / (from - to)), along)];
  });
}

/** Whether the way from one point to another crosses the ray that runs from a third to the right. */
const crossesRay = ([ax, ay]: Point, [bx, by]: Point, [x, y]: Point): boolean =>
  ay > y !== by > y && x < ax + ((y - ay) / (by - ay)) * (bx - ax);

/** Whether a closed line goes round a point. */
export const isInside = (loop: readonly Point[], point: Point): boolean =>
  loop.reduce(
    (odd, from, k) => crossesRay(from, loop[(k + 1) % loop.length] ?? from, point) !== odd,
    false,
  );

/** Upright, from its lower left corner to its upper right one. */
export interface Box {
  readonly low: Point;
  readonly high: Point;
}

/** The least box around points. */
export function boxOf(points: readonly Point[]): Box {
  let [left, lower, right, upper] = [Infinity, Infinity, -Infinity, -Infinity];
  for (const [x, y] of points) {
    [left, right] = [Math.min(left, x), Math.max(right, x)];
    [lower, upper] = [Math.min(lower, y), Math.max(upper, y)];
  }
  return {low: [left, lower], high: [right, upper]};
}

/** From a point to a closed line. */
export function distanceTo(loop: readonly Point[], p: Point): number {
  let nearest = Infinity;
  loop.forEach((a, k) => {
    const b = loop[(k + 1) % loop.length] ?? a;
    nearest = Math.min(nearest, distance(p, between(a, b, nearestShare(a, b, p))));
  });
  return nearest;
}

/** The stretches of a straight line that lie within a closed one and outside of its holes. */
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
