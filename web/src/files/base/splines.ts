/** Splines through key points, as in CAD programs. */
import {distance, minus, plus, type Point} from '../../model/geometry/vectors.js';
import type {CubicFrom} from './bezier.js';

/** The kind of spline through key points; it depends on the program. */
export type SplineRule = 'catmull-rom' | 'natural';

export const splineThrough = (points: readonly Point[], rule: SplineRule): CubicFrom[] =>
  rule === 'natural' ? natural(points) : catmullRom(points);

const scaled = ([x, y]: Point, by: number): Point => [by * x, by * y];

/** A cubic for one segment, from the velocities at its ends and its duration. */
const hermite = (
  from: Point,
  to: Point,
  leaving: Point,
  arriving: Point,
  time: number,
): CubicFrom => [plus(from, leaving, time / 3), plus(to, arriving, -time / 3), to];

/**
 * Catmull-Rom spline: each velocity is that of the parabola through a point and its neighbours,
 * parametrised by square roots of distances.
 */
function catmullRom(points: readonly Point[]): CubicFrom[] {
  const times = points.slice(1).map((to, k) => Math.sqrt(distance(points[k] ?? to, to)) || 1);
  const speeds = points
    .slice(1)
    .map((to, k) => scaled(minus(to, points[k] ?? to), 1 / (times[k] ?? 1)));
  const velocities = points.map((_, k): Point => {
    const [before, after] = [speeds[k - 1], speeds[k]];
    if (!before || !after) return endVelocity(before ?? after ?? [0, 0]);
    const [s, t] = [times[k - 1] ?? 1, times[k] ?? 1];
    return scaled(plus(scaled(before, t), after, s), 1 / (s + t));
  });
  return steps(points, velocities, times);
}

const endVelocity = (step: Point): Point => step;

const steps = (
  points: readonly Point[],
  velocities: readonly Point[],
  times: readonly number[],
): CubicFrom[] =>
  points
    .slice(1)
    .map((to, k) =>
      hermite(
        points[k] ?? to,
        to,
        velocities[k] ?? [0, 0],
        velocities[k + 1] ?? [0, 0],
        times[k] ?? 1,
      ),
    );

/**
 * Natural cubic spline: twice continuously differentiable in chord length, without curvature at its
 * ends.
 */
function natural(points: readonly Point[]): CubicFrom[] {
  const times = points.slice(1).map((to, k) => distance(points[k] ?? to, to) || 1);
  const speeds = points
    .slice(1)
    .map((to, k) => scaled(minus(to, points[k] ?? to), 1 / (times[k] ?? 1)));
  // velocities v: v[k-1]/h[k-1] + 2 (1/h[k-1] + 1/h[k]) v[k] + v[k+1]/h[k] = 3 (s[k-1]/h[k-1] +
  // s[k]/h[k])
  const factors: number[] = [];
  const sides: Point[] = [];
  points.forEach((_, k) => {
    const [before, after] = [times[k - 1], times[k]].map((time) =>
      time === undefined ? 0 : 1 / time,
    ) as [number, number];
    const side = plus(scaled(speeds[k - 1] ?? [0, 0], 3 * before), speeds[k] ?? [0, 0], 3 * after);
    const pivot = 2 * (before + after) - before * (factors[k - 1] ?? 0);
    factors.push(after / pivot);
    sides.push(scaled(plus(side, sides[k - 1] ?? [0, 0], -before), 1 / pivot));
  });
  const velocities: Point[] = [];
  for (let k = points.length - 1; k >= 0; k--) {
    velocities[k] = plus(sides[k] ?? [0, 0], velocities[k + 1] ?? [0, 0], -(factors[k] ?? 0));
  }
  return steps(points, velocities, times);
}
