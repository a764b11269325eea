/** Converts arcs and splines to dense points. */
import {
  between,
  distance,
  leftOf,
  middle,
  minus,
  plus,
  rotated,
  towards,
  radians,
  type Point,
} from '../../model/geometry/vectors.js';
import type {Vertex} from './tags.js';

/** Angle between two points of an arc. [rad] */
const arcStep = Math.PI / 90;

/** Points per knot span of a spline. */
const splineSteps = 16;

const range = (count: number): number[] => Array.from({length: count}, (_, k) => k);

/**
 * Points of an arc, including both ends.
 * @param sweep counter-clockwise if positive [rad]
 */
function arcPoints(centre: Point, from: Point, sweep: number): Point[] {
  const count = Math.max(8, Math.ceil(Math.abs(sweep) / arcStep));
  const radius = minus(from, centre);
  return range(count + 1).map((k) => plus(centre, rotated(radius, (k / count) * sweep)));
}

/**
 * Points of an elliptical arc.
 * @param axis vector of the major semi-axis
 * @param ratio of the minor axis to the major axis
 * @param span parameters of both ends [rad]
 */
export function ellipsePoints(
  centre: Point,
  axis: Point,
  ratio: number,
  [from, to]: readonly [number, number],
): Point[] {
  const sweep = to > from ? to - from : to - from + 2 * Math.PI;
  const count = Math.max(8, Math.ceil(sweep / arcStep));
  return range(count + 1).map((k) => {
    const [c, s] = towards(from + (k / count) * sweep);
    return plus(plus(centre, axis, c), leftOf(axis), s * ratio);
  });
}

/** Points of a polyline with arcs. A bulge is the tangent of a quarter of the arc's angle. */
export function bulgePoints(vertices: readonly Vertex[], isClosed: boolean): Point[] {
  return vertices.flatMap(({at, bulge}, k) => {
    const next = vertices[k + 1] ?? (isClosed ? vertices[0] : undefined);
    if (!next || bulge === 0 || distance(at, next.at) === 0) return [at];
    const sweep = 4 * Math.atan(bulge);
    const off = (1 / bulge - bulge) / 4;
    const centre = plus(middle(at, next.at), leftOf(minus(next.at, at)), off);
    return arcPoints(centre, at, sweep).slice(0, -1);
  });
}

/** Properties of a spline in addition to its control points. */
interface Spline {
  readonly degree: number;
  /** Number of control points + degree + 1 knots. */
  readonly knots: readonly number[];
  readonly weights: readonly number[];
}

export function splinePoints(
  controls: readonly Point[],
  {degree, knots, weights}: Spline,
): Point[] {
  const spans = range(controls.length - degree)
    .map((k) => k + degree)
    .filter((k) => (knots[k + 1] ?? 0) > (knots[k] ?? 0));
  const at = (span: number, share: number): Point => {
    const [low, high] = [knots[span] ?? 0, knots[span + 1] ?? 0];
    return deBoor(controls, {degree, knots, weights}, span, low + share * (high - low));
  };
  const [last] = spans.slice(-1);
  return [
    ...spans.flatMap((span) => range(splineSteps).map((k) => at(span, k / splineSteps))),
    ...(last === undefined ? [] : [at(last, 1)]),
  ];
}

type Weighted = readonly [x: number, y: number, weight: number];

/** De Boor's algorithm in homogeneous coordinates. */
function deBoor(
  controls: readonly Point[],
  {degree, knots, weights}: Spline,
  span: number,
  t: number,
): Point {
  let row = range(degree + 1).map((j): Weighted => {
    const k = span - degree + j;
    const [x, y] = controls[k] ?? [0, 0];
    const weight = weights[k] ?? 1;
    return [weight * x, weight * y, weight];
  });
  for (let level = 1; level <= degree; level++) {
    row = row.slice(1).map((right, j): Weighted => {
      const k = span - degree + level + j;
      const [low, high] = [knots[k] ?? 0, knots[k + degree + 1 - level] ?? 0];
      const share = high > low ? (t - low) / (high - low) : 0;
      const left = row[j] ?? right;
      const [x, y] = between([left[0], left[1]], [right[0], right[1]], share);
      return [x, y, left[2] + share * (right[2] - left[2])];
    });
  }
  const [x, y, weight] = row[0] ?? [0, 0, 1];
  return [x / weight, y / weight];
}

export const circlePoints = (centre: Point, radius: number): Point[] =>
  arcPoints(centre, plus(centre, [radius, 0]), 2 * Math.PI);

/**
 * Points of a circular arc.
 * @param angles of both ends, counter-clockwise [degrees]
 */
export function circularPoints(
  centre: Point,
  radius: number,
  [from, to]: readonly [number, number],
): Point[] {
  const sweep = radians(to - from);
  const start = plus(centre, towards(radians(from)), radius);
  return arcPoints(centre, start, sweep > 0 ? sweep : sweep + 2 * Math.PI);
}
