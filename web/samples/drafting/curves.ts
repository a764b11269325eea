/**
 * Curves for drafting: straight and cubic Bezier edges, their length, and truing one length to
 * another. Lengths in cm.
 */
import {
  between,
  distance,
  minus,
  norm,
  plus,
  type Point,
} from '../../src/model/geometry/vectors.js';

/** A straight edge, or a cubic Bezier curve when it has controls. */
export interface Curve {
  readonly from: Point;
  readonly to: Point;
  readonly controls?: readonly [Point, Point];
}

/** The unit vector at `angle` (radians) from straight up towards +x. */
export const leaning = (angle: number): Point => [Math.sin(angle), Math.cos(angle)];

/** x -> -x, the map between the two sides of a body. Exact. */
export const mirror = (a: Point): Point => [-a[0], a[1]];

export const line = (from: Point, to: Point): Curve => ({from, to});

/**
 * A curve that leaves `from` along `out` and arrives at `to` along `into` (unit vectors, both in
 * the direction of travel), with handles of the given lengths in cm. The default is a third of the
 * chord, which gives the fairest curve.
 */
export function curve(
  from: Point,
  out: Point,
  to: Point,
  into: Point,
  handleFrom?: number,
  handleTo?: number,
): Curve {
  const third = distance(to, from) / 3;
  return {
    from,
    to,
    controls: [plus(from, out, handleFrom ?? third), plus(to, into, -(handleTo ?? third))],
  };
}

/** A curve from (-x, y) to (x, y), its own mirror image, arriving along `into`. */
export function across(to: Point, into: Point, handle = (2 * to[0]) / 3): Curve {
  const control = plus(to, into, -handle);
  return {from: mirror(to), to, controls: [mirror(control), control]};
}

export function reversed({from, to, controls}: Curve): Curve {
  return controls
    ? {from: to, to: from, controls: [controls[1], controls[0]]}
    : {from: to, to: from};
}

/** The image of a curve under a map that keeps straight lines: a motion, a mirror, a scaling. */
export function mapped({from, to, controls}: Curve, map: (p: Point) => Point): Curve {
  const ends = {from: map(from), to: map(to)};
  return controls ? {...ends, controls: [map(controls[0]), map(controls[1])]} : ends;
}

export const mirrored = (curve: Curve): Curve => mapped(curve, mirror);

/** A curve with the same start that is exactly its own mirror image, for one that is nearly so. */
export function evened({from, controls}: Curve): Curve {
  const ends = {from, to: mirror(from)};
  return controls ? {...ends, controls: [controls[0], mirror(controls[0])]} : ends;
}

export const moved = (curve: Curve, by: Point): Curve => mapped(curve, (p) => plus(p, by));

/**
 * The mirror image in the line through `a` and `b`: the position of the fabric beyond a seam after
 * unfolding.
 */
export function reflectedIn(a: Point, b: Point): (p: Point) => Point {
  const along = minus(b, a);
  const square = norm(along) ** 2;
  return (p) => {
    const [x, y] = minus(p, a);
    const foot = plus(a, along, (x * along[0] + y * along[1]) / square);
    return plus(foot, minus(foot, p));
  };
}

export function pointAt({from, to, controls}: Curve, t: number): Point {
  const s = 1 - t;
  if (!controls) return [s * from[0] + t * to[0], s * from[1] + t * to[1]];
  const [c, d] = controls;
  const at = (i: 0 | 1): number =>
    s * s * s * from[i] + 3 * s * s * t * c[i] + 3 * s * t * t * d[i] + t * t * t * to[i];
  return [at(0), at(1)];
}

/** The derivative at parameter t; its direction is the direction of travel. */
export function velocity({from, to, controls}: Curve, t: number): Point {
  if (!controls) return minus(to, from);
  const [c, d] = controls;
  const s = 1 - t;
  const at = (i: 0 | 1): number =>
    3 * (s * s * (c[i] - from[i]) + 2 * s * t * (d[i] - c[i]) + t * t * (to[i] - d[i]));
  return [at(0), at(1)];
}

const gaussNodes = [
  -0.906179845938664, -0.5384693101056831, 0, 0.5384693101056831, 0.906179845938664,
];
const gaussWeights = [
  0.2369268850561891, 0.4786286704993665, 0.5688888888888889, 0.4786286704993665,
  0.2369268850561891,
];
const spans = 12;

/** Arc length by Gauss-Legendre quadrature; exact to 1e-9 cm for the curves of a garment. */
export function length(curve: Curve): number {
  if (!curve.controls) return distance(curve.to, curve.from);
  let sum = 0;
  for (let span = 0; span < spans; span++) {
    gaussNodes.forEach((node, k) => {
      sum += (gaussWeights[k] ?? 0) * norm(velocity(curve, (span + (node + 1) / 2) / spans));
    });
  }
  return sum / (2 * spans);
}

/**
 * The argument between `low` and `high` at which `measure` takes the value `target`; trues a
 * pattern. Uses the Illinois rule: the secant method, but an end that stays twice counts half.
 * @throws {RangeError} if the target is out of range: the pattern cannot be drafted for these
 * measurements
 */
export function trueTo(
  what: string,
  target: number,
  measure: (x: number) => number,
  low: number,
  high: number,
): number {
  let [a, b] = [low, high];
  let [atA, atB] = [measure(a) - target, measure(b) - target];
  if (!(atA * atB <= 0)) {
    throw new RangeError(`${what} cannot be made ${target.toFixed(1)} cm with these measurements`);
  }
  while (Math.abs(atB) > 1e-11 && Math.abs(b - a) > 1e-13 * Math.abs(high - low)) {
    const x = b - (atB * (b - a)) / (atB - atA);
    const atX = measure(x) - target;
    if (atX * atB < 0) [a, atA] = [b, atB];
    else atA /= 2;
    [b, atB] = [x, atX];
  }
  return b;
}

/** The two parts of a curve before and after parameter t, exactly. */
function split({from, to, controls}: Curve, t: number): readonly [Curve, Curve] {
  if (!controls) {
    const at = between(from, to, t);
    return [line(from, at), line(at, to)];
  }
  const [c, d] = controls;
  const [first, second, third] = [between(from, c, t), between(c, d, t), between(d, to, t)];
  const [near, far] = [between(first, second, t), between(second, third, t)];
  const at = between(near, far, t);
  return [
    {from, to: at, controls: [first, near]},
    {from: at, to, controls: [far, third]},
  ];
}

/** Splits a curve where `measure`, a function of the point, takes the value `target`. */
export function splitWhere(
  what: string,
  whole: Curve,
  measure: (p: Point) => number,
  target: number,
): readonly [Curve, Curve] {
  return split(
    whole,
    trueTo(what, target, (t) => measure(pointAt(whole, t)), 0, 1),
  );
}

/** Splits a curve into pieces of the given lengths, in cm from its start, and the rest. */
export function splitAtLengths(what: string, whole: Curve, lengths: readonly number[]): Curve[] {
  const [first, ...others] = lengths;
  if (first === undefined) return [whole];
  const [piece, rest] = split(
    whole,
    trueTo(what, first, (t) => length(split(whole, t)[0]), 0, 1),
  );
  return [piece, ...splitAtLengths(what, rest, others)];
}

/** The parameter after a share of a curve's length; 0 and 1 are its ends. */
export function parameterAt(whole: Curve, share: number): number {
  if (share <= 0 || share >= 1) return Math.round(share);
  const target = share * length(whole);
  return trueTo('a mark', target, (t) => length(split(whole, t)[0]), 0, 1);
}

/**
 * Handle length at a cubic's end for the given curvature (1/cm) there, if the other control is
 * `offset` cm off the tangent. Curves with the same end and curvature continue into each other
 * without a bump.
 */
export const handleFor = (curvature: number, offset: number): number =>
  Math.sqrt((2 * offset) / (3 * curvature));
