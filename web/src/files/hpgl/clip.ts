/** Clips lines to a band. */
import {between, type Point} from '../../model/geometry/vectors.js';

/** The part of a segment with x from `from` to `to`; undefined if it lies outside. */
function inBand(a: Point, b: Point, from: number, to: number): [Point, Point] | undefined {
  const at = (x: number): Point => [x, between(a, b, (x - a[0]) / (b[0] - a[0]))[1]];
  const end = (p: Point): Point => (p[0] < from ? at(from) : p[0] > to ? at(to) : p);
  if (Math.max(a[0], b[0]) < from || Math.min(a[0], b[0]) > to) return undefined;
  return [end(a), end(b)];
}

const isSame = (a: Point | undefined, b: Point): boolean => a?.[0] === b[0] && a[1] === b[1];

/**
 * The parts of a line with x from `from` to `to`. Segments along the end `to` belong to the next
 * band.
 */
export function clippedTo(line: readonly Point[], from: number, to: number): Point[][] {
  const parts: Point[][] = [];
  line.slice(1).forEach((b, k) => {
    const a = line[k] ?? b;
    const part = a[0] >= to && b[0] >= to ? undefined : inBand(a, b, from, to);
    if (!part || (isSame(part[0], part[1]) && !isSame(a, b))) return;
    const last = parts.at(-1);
    if (isSame(last?.at(-1), part[0])) last?.push(part[1]);
    else parts.push(part);
  });
  return parts;
}
