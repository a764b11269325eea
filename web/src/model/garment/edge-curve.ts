/** Edges of outlines as curves: points, lengths and splits. Lengths in cm. */
import type {DraftedEdge} from './garment-document.js';
import {
  between,
  distance,
  leftOf,
  middle,
  minus,
  plus,
  rotated,
  type Point,
} from '../geometry/vectors.js';

type Controls = readonly [Point, Point, ...Point[]];

/** Steps per Bezier curve of a line for drawing or measuring distances. */
const usualSteps = 32;
/**
 * Equal parts of a Bezier curve in the length integral. Five nodes in each give a relative error of
 * 1e-9.
 */
const parts = 16;
/** Nodes and weights of Gauss-Legendre quadrature on [-1, 1]. */
const nodes = [0, -0.538469310105683, 0.538469310105683, -0.906179845938664, 0.906179845938664];
const weights = [
  0.568888888888889, 0.478628670499366, 0.478628670499366, 0.236926885056189, 0.236926885056189,
];

/** Curves of an edge: a line, a curve with one or two control points, or the cubics of a chain. */
function curvesOf({points}: DraftedEdge): readonly Controls[] {
  if (points.length <= 4) return [points];
  const count = Math.floor((points.length - 1) / 3);
  return Array.from(
    {length: count},
    (_, k) => points.slice(3 * k, 3 * k + 4) as unknown as Controls,
  );
}

/** Splits a Bezier curve at a parameter from 0 to 1 (de Casteljau). */
function halves(controls: Controls, t: number): readonly [Controls, Controls] {
  const first: Point[] = [];
  const second: Point[] = [];
  for (let row: readonly Point[] = controls; row.length > 0;) {
    const [head, tail] = [row[0], row.at(-1)];
    if (head) first.push(head);
    if (tail) second.unshift(tail);
    const before = row;
    row = row.slice(1).map((to, k) => between(before[k] ?? to, to, t));
  }
  return [first as unknown as Controls, second as unknown as Controls];
}

const pointAt = (controls: Controls, t: number): Point =>
  t >= 1 ? (controls.at(-1) ?? controls[0]) : halves(controls, t)[1][0];

/**
 * Length of the derivative by the parameter, for a line or a curve with one or two control points.
 */
function speedOf(controls: Controls): (t: number) => number {
  const count = controls.length - 1;
  const [a, b = a, c = b] = controls.slice(1).map((to, k) => minus(to, controls[k] ?? to));
  if (!a || !b || !c) return () => 0;
  const [first, second, third] = count === 2 ? [a, middle(a, b), b] : [a, b, c];
  return (t) => {
    const u = 1 - t;
    const [p, q, r] = [u * u, 2 * u * t, t * t];
    const x = p * first[0] + q * second[0] + r * third[0];
    return count * Math.hypot(x, p * first[1] + q * second[1] + r * third[1]);
  };
}

/** Length of a Bezier curve from its start to a parameter. */
function lengthTo(controls: Controls, t: number, speed = speedOf(controls)): number {
  if (controls.length === 2) return t * distance(controls[0], controls[1]);
  const half = t / parts / 2;
  let sum = 0;
  for (let part = 0; part < parts; part++)
    for (let k = 0; k < nodes.length; k++)
      sum += (weights[k] ?? 0) * speed(half * (2 * part + 1 + (nodes[k] ?? 0)));
  return half * sum;
}

/**
 * Parameter at a length from the start of a Bezier curve: Newton steps, or bisection where those
 * leave the bracket.
 */
function parameterAt(controls: Controls, length: number): number {
  if (controls.length === 2) return length / (distance(controls[0], controls[1]) || 1);
  const speed = speedOf(controls);
  const whole = lengthTo(controls, 1, speed);
  let [low, high, t] = [0, 1, length / (whole || 1)];
  for (let k = 0; k < 60 && high - low > 1e-15; k++) {
    const miss = lengthTo(controls, t, speed) - length;
    if (Math.abs(miss) <= 1e-14 * whole) break;
    if (miss < 0) low = t;
    else high = t;
    const step = t - miss / speed(t);
    t = step > low && step < high ? step : (low + high) / 2;
  }
  return t;
}

/** Centre of a circular arc. */
export function centreOf({points}: DraftedEdge, sweep: number): Point {
  const [from, to] = [points[0], points.at(-1) ?? points[0]];
  return plus(middle(from, to), leftOf(minus(to, from)), 0.5 / Math.tan(sweep / 2));
}

/** Point of a circular arc at a share of its length. */
const arcAt = (edge: DraftedEdge, sweep: number, share: number): Point => {
  const centre = centreOf(edge, sweep);
  return plus(centre, rotated(minus(edge.points[0], centre), share * sweep));
};

/** Steps per curve at which points and lengths are exact to 0.001 mm. */
export const exactSteps = 512;

/** Closely spaced points of an edge, from its start to its end. @param steps per Bezier curve */
export function edgeLine(edge: DraftedEdge, steps = usualSteps): readonly Point[] {
  const {points, sweep} = edge;
  const last = points.at(-1) ?? points[0];
  if (sweep !== undefined)
    return [
      points[0],
      ...Array.from({length: 2 * steps - 1}, (_, k) => arcAt(edge, sweep, (k + 1) / (2 * steps))),
      last,
    ];
  if (points.length === 2) return points;
  return [
    points[0],
    ...curvesOf(edge).flatMap((controls) =>
      Array.from({length: steps}, (_, k) => pointAt(controls, (k + 1) / steps)),
    ),
  ];
}

/** Length of an edge. [cm] */
export function edgeLength(edge: DraftedEdge): number {
  const {points, sweep} = edge;
  if (sweep !== undefined) return Math.abs(sweep) * distance(points[0], centreOf(edge, sweep));
  return curvesOf(edge).reduce((sum, controls) => sum + lengthTo(controls, 1), 0);
}

/**
 * Splits an edge in two without changing its course.
 * @param share of its length, between 0 and 1
 */
export function splitCurve(edge: DraftedEdge, share: number): readonly [DraftedEdge, DraftedEdge] {
  const {points, sweep} = edge;
  if (sweep !== undefined) {
    const at = arcAt(edge, sweep, share);
    return [
      {...edge, points: [points[0], at], sweep: share * sweep},
      {...edge, points: [at, points.at(-1) ?? at], sweep: (1 - share) * sweep},
    ];
  }
  const curves = curvesOf(edge);
  const lengths = curves.map((controls) => lengthTo(controls, 1));
  let left = share * lengths.reduce((sum, length) => sum + length, 0);
  let number = 0;
  while (number < curves.length - 1 && left > (lengths[number] ?? 0))
    left -= lengths[number++] ?? 0;
  const split = curves[number] ?? points;
  const [first, second] = halves(split, parameterAt(split, left));
  const before = curves.slice(0, number);
  const after = curves.slice(number + 1);
  return [
    {...edge, points: joined([...before, first])},
    {...edge, points: joined([second, ...after])},
  ];
}

/** Joins curves to a chain; each begins where the one before ends. */
const joined = ([first, ...others]: readonly Controls[]): Controls =>
  [...(first ?? []), ...others.flatMap((controls) => controls.slice(1))] as unknown as Controls;
