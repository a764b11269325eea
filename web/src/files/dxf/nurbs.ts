/** Converts B-splines, rational ones included, to chains of cubics by knot insertion. */
import type {Run} from '../../model/garment/imported-drawing.js';
import {between, distance, minus, plus, type Point} from '../../model/geometry/vectors.js';
import {pointAt, type Cubic, type CubicFrom} from '../base/bezier.js';

/** Properties of a spline in addition to its control points. */
interface Spline {
  readonly degree: number;
  /** Number of control points + degree + 1 knots. */
  readonly knots: readonly number[];
  readonly weights: readonly number[];
}

/** A control point in homogeneous coordinates. */
type Weighted = readonly [x: number, y: number, weight: number];

/** Greatest error, as a share of the spline's size: 0.005 mm per metre. */
const share = 5e-6;

/** Greatest number of halvings of a span. */
const deepest = 10;

export function splineRun(controls: readonly Point[], spline: Spline): Run {
  const {degree, knots, weights} = spline;
  const isRational = weights.some((weight) => Math.abs(weight - (weights[0] ?? 1)) > 1e-9);
  const [first = [0, 0]] = controls;
  const size = Math.max(...controls.map((control) => distance(control, first)));
  const points = controls.map(([x, y], k): Weighted => {
    const weight = isRational ? (weights[k] ?? 1) : 1;
    return [weight * x, weight * y, weight];
  });
  const spans = Array.from({length: controls.length - degree}, (_, k) => k + degree)
    .filter((k) => (knots[k + 1] ?? 0) > (knots[k] ?? 0))
    .map((k) => bezierOf(points, spline, k));
  const start = spans[0]?.[0] ?? [0, 0, 1];
  const isCubic = !isRational && degree <= 3;
  return {
    start: flat(start),
    cubics: spans.flatMap((span) =>
      isCubic ? [elevated(span.map(flat))] : approximated(span, share * size, deepest),
    ),
  };
}

const flat = ([x, y, weight]: Weighted): Point => [x / weight, y / weight];

const mixed = (a: Weighted, b: Weighted, at: number): Weighted => [
  a[0] + at * (b[0] - a[0]),
  a[1] + at * (b[1] - a[1]),
  a[2] + at * (b[2] - a[2]),
];

/** The Bezier points of one knot span, each the blossom at copies of both knots. */
function bezierOf(
  controls: readonly Weighted[],
  {degree, knots}: Spline,
  span: number,
): Weighted[] {
  const [low, high] = [knots[span] ?? 0, knots[span + 1] ?? 0];
  return Array.from({length: degree + 1}, (_, upper) => {
    let row = controls.slice(span - degree, span + 1);
    for (let level = 1; level <= degree; level++) {
      const t = level <= upper ? high : low;
      row = row.slice(1).map((right, j) => {
        const k = span - degree + level + j;
        const [from, to] = [knots[k] ?? 0, knots[k + degree + 1 - level] ?? 0];
        return mixed(row[j] ?? right, right, to > from ? (t - from) / (to - from) : 0);
      });
    }
    return row[0] ?? [0, 0, 1];
  });
}

/** A Bezier curve of degree 1 to 3 as a cubic. */
function elevated(points: readonly Point[]): CubicFrom {
  const [a = [0, 0], b = a, c = b, d] = points;
  if (d) return [b, c, d];
  if (points.length === 3) return [between(a, b, 2 / 3), between(c, b, 2 / 3), c];
  return [between(a, b, 1 / 3), between(a, b, 2 / 3), b];
}

/** A Bezier curve of any degree as cubics with its ends and tangents, halved until they fit. */
function approximated(points: readonly Weighted[], tolerance: number, depth: number): CubicFrom[] {
  const degree = points.length - 1;
  const [first = [0, 0, 1], second = first] = points;
  const [last = first, before = last] = [...points].reverse();
  // the derivative of a rational Bezier curve at its ends
  const velocity = (from: Weighted, to: Weighted): Point => {
    const [x, y] = minus(flat(to), flat(from));
    const factor = (degree * to[2]) / from[2];
    return [factor * x, factor * y];
  };
  const [start, end] = [flat(first), flat(last)];
  const cubic: Cubic = [
    start,
    plus(start, velocity(first, second), 1 / 3),
    plus(end, velocity(last, before), 1 / 3),
    end,
  ];
  const isClose = [0.25, 0.5, 0.75].every(
    (t) => distance(pointAt(cubic, t), flat(divided(points, t).middle)) <= tolerance,
  );
  if (isClose || depth === 0) return [[cubic[1], cubic[2], cubic[3]]];
  const {left, right} = divided(points, 0.5);
  return [
    ...approximated(left, tolerance, depth - 1),
    ...approximated(right, tolerance, depth - 1),
  ];
}

/** De Casteljau's division of a curve. */
function divided(
  points: readonly Weighted[],
  t: number,
): {readonly left: Weighted[]; readonly right: Weighted[]; readonly middle: Weighted} {
  const [left, right]: [Weighted[], Weighted[]] = [[], []];
  let row = points;
  for (;;) {
    const [first = [0, 0, 1] as const] = row;
    left.push(first);
    right.unshift(row.at(-1) ?? first);
    if (row.length <= 1) return {left, right, middle: first};
    row = row.slice(1).map((to, k) => mixed(row[k] ?? to, to, t));
  }
}
