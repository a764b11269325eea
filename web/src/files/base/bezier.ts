/** Cubic Bezier curves and chains of them. Lengths in the unit of the file. */
import type {Run} from '../../model/garment/imported-drawing.js';
import {
  between,
  cross,
  dot,
  middle,
  minus,
  norm,
  plus,
  type Point,
} from '../../model/geometry/vectors.js';

export type Cubic = readonly [start: Point, first: Point, second: Point, end: Point];
export type CubicFrom = readonly [first: Point, second: Point, end: Point];

export const straight = (from: Point, to: Point): CubicFrom => [
  between(from, to, 1 / 3),
  between(from, to, 2 / 3),
  to,
];

export const endOf = ({start, cubics}: Run): Point => cubics.at(-1)?.[2] ?? start;

/** The curves of a run, each with its start. */
export const cubicsOf = ({start, cubics}: Run): Cubic[] =>
  cubics.map(([first, second, end], k) => [cubics[k - 1]?.[2] ?? start, first, second, end]);

export const mapped = ({start, cubics}: Run, map: (point: Point) => Point): Run => ({
  start: map(start),
  cubics: cubics.map(([first, second, end]) => [map(first), map(second), map(end)]),
});

export const reversed = (run: Run): Run => ({
  start: endOf(run),
  cubics: cubicsOf(run)
    .map(([start, first, second]): CubicFrom => [second, first, start])
    .reverse(),
});

/** A closed line in the opposite direction, from the same start. */
export const reversedLoop = (loop: readonly Run[]): Run[] => loop.map(reversed).reverse();

/** The point of a curve at a parameter from 0 to 1. */
export const pointAt = ([a, b, c, d]: Cubic, t: number): Point => {
  const u = 1 - t;
  const [p, q, r, s] = [u * u * u, 3 * u * u * t, 3 * u * t * t, t * t * t];
  return [p * a[0] + q * b[0] + r * c[0] + s * d[0], p * a[1] + q * b[1] + r * c[1] + s * d[1]];
};

/** Returns whether a curve is straight within a tolerance. */
export const isStraight = ([start, first, second, end]: Cubic, tolerance: number): boolean => {
  const way = minus(end, start);
  const length = norm(way);
  return [first, second].every((control) => {
    const off = minus(control, start);
    const along = dot(off, way);
    return (
      Math.abs(cross(way, off)) <= tolerance * length &&
      along >= -tolerance * length &&
      along <= (length + tolerance) * length
    );
  });
};

/** Returns whether a whole run is straight within a tolerance. */
export const isLine = (run: Run, tolerance: number): boolean =>
  run.cubics.flat().every((point) => isStraight([run.start, point, point, endOf(run)], tolerance));

/**
 * Adds the points along a curve without its start; the lines between them are within a tolerance of
 * the curve.
 */
function trace(cubic: Cubic, tolerance: number, points: Point[]): void {
  const [a, b, c, d] = cubic;
  const bend = Math.max(norm(plus(minus(a, b), minus(c, b))), norm(plus(minus(b, c), minus(d, c))));
  const steps = Math.min(200, Math.max(1, Math.ceil(Math.sqrt((0.75 * bend) / tolerance))));
  for (let k = 1; k < steps; k++) points.push(pointAt(cubic, k / steps));
  points.push(d);
}

/** Points along a run, from start to end. */
export function tracedRun({start, cubics}: Run, tolerance: number): Point[] {
  const points = [start];
  for (const [first, second, end] of cubics) {
    trace([points.at(-1) ?? start, first, second, end], tolerance, points);
  }
  return points;
}

/** Points along a closed line, without repeating the first. */
export const tracedLoop = (loop: readonly Run[], tolerance: number): Point[] =>
  loop.flatMap((run) => tracedRun(run, tolerance).slice(0, -1));

/** Both halves of a curve. */
export function halved([a, b, c, d]: Cubic): [Cubic, Cubic] {
  const [ab, bc, cd] = [middle(a, b), middle(b, c), middle(c, d)];
  const [abc, bcd] = [middle(ab, bc), middle(bc, cd)];
  const half = middle(abc, bcd);
  return [
    [a, ab, abc, half],
    [half, bcd, cd, d],
  ];
}
