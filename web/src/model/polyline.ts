/** Lines through points, open or closed. Lengths in cm. */
import {between, cross, distance, dot, minus, unit, type Point} from './geometry.js';

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
  const xs = points.map(([x]) => x);
  const ys = points.map(([, y]) => y);
  return {low: [Math.min(...xs), Math.min(...ys)], high: [Math.max(...xs), Math.max(...ys)]};
}
