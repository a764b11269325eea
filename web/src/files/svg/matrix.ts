/** Affine maps in SVG notation: x' = a x + c y + e, y' = b x + d y + f. */
import {radians, type Point} from '../../model/geometry/vectors.js';

export type Matrix = readonly [a: number, b: number, c: number, d: number, e: number, f: number];

export const mapped = ([a, b, c, d, e, f]: Matrix, [x, y]: Point): Point => [
  a * x + c * y + e,
  b * x + d * y + f,
];

/** The composition: first `inner`, then `outer`. */
export const composed = (outer: Matrix, inner: Matrix): Matrix => {
  const [a, b, c, d, e, f] = inner;
  const [x, y] = mapped(outer, [e, f]);
  return [
    ...[outer[0] * a + outer[2] * b, outer[1] * a + outer[3] * b],
    ...[outer[0] * c + outer[2] * d, outer[1] * c + outer[3] * d],
    ...[x, y],
  ] as unknown as Matrix;
};

export const shift = (x: number, y: number): Matrix => [1, 0, 0, 1, x, y];
export const scaling = (x: number, y = x): Matrix => [x, 0, 0, y, 0, 0];

/** The mean scale factor of lengths. */
export const growth = ([a, b, c, d]: Matrix): number => Math.sqrt(Math.abs(a * d - b * c));

/** Returns whether a map collapses the plane to a line or a point. */
export const isFlat = (m: Matrix): boolean =>
  !(growth(m) ** 2 > 1e-6 * Math.hypot(m[0], m[1], m[2], m[3]) ** 2);

function turn(degrees: number, x = 0, y = 0): Matrix {
  const [c, s] = [Math.cos(radians(degrees)), Math.sin(radians(degrees))];
  return composed(shift(x, y), composed([c, s, -s, c, 0, 0], shift(-x, -y)));
}

const tan = (degrees: number): number => Math.tan(radians(degrees));

/** One function of a `transform`; undefined for a wrong number of arguments. */
function step(name: string, n: readonly number[]): Matrix | undefined {
  const [p = 0, q] = n;
  if (name === 'matrix' && n.length === 6) return n as unknown as Matrix;
  if (name === 'translate' && n.length <= 2) return shift(p, q ?? 0);
  if (name === 'scale' && n.length <= 2) return scaling(p, q ?? p);
  if (name === 'rotate' && (n.length === 1 || n.length === 3)) return turn(p, q, n[2]);
  if (name === 'skewX' && n.length === 1) return [1, 0, tan(p), 1, 0, 0];
  return name === 'skewY' && n.length === 1 ? [1, tan(p), 0, 1, 0, 0] : undefined;
}

/** Numbers of a list separated by spaces or commas. */
export const numbersOf = (list: string | undefined): number[] =>
  (list ?? '').match(/[-+]?(?:\d+\.?\d*|\.\d+)(?:e[-+]?\d+)?/gi)?.map(Number) ?? [];

/**
 * The scales of a view box in its view by `preserveAspectRatio`.
 * @param across view's width divided by that of its box
 * @param down the same of the heights
 */
export function fitOf(rule: string | undefined, across: number, down: number): Point {
  const words = (rule ?? '').trim().split(/\s+/);
  if (words[0] === 'none') return [across, down];
  const scale = words.includes('slice') ? Math.max(across, down) : Math.min(across, down);
  return [scale, scale];
}

/** User units per unit of a length. */
const userUnits: Readonly<Record<string, number>> = {
  ...{px: 1, in: 96, cm: 96 / 2.54, mm: 96 / 25.4, q: 24 / 25.4, pt: 4 / 3, pc: 16},
};

/**
 * A length in user units; undefined if it is missing or invalid.
 * @param whole length of 100 per cent
 */
export function lengthOf(value: string | undefined, whole: number): number | undefined {
  const [number] = numbersOf(value);
  if (number === undefined) return undefined;
  const [, unit = ''] = /^[-+.\d]+(?:e[-+]?\d+)?([a-z%]*)/i.exec((value ?? '').trim()) ?? [];
  return unit === '%' ? (number / 100) * whole : number * (userUnits[unit.toLowerCase()] ?? 1);
}

/** The map of a `transform` attribute; undefined if it is invalid. */
export function matrixOf(transform: string | undefined): Matrix | undefined {
  let whole: Matrix = scaling(1);
  const rest = (transform ?? '').replaceAll(
    /([a-z]{1,12}[XY]?)\s{0,9}\(([^()]{0,400})\)/gi,
    (_, name: string, list: string) => {
      const numbers = numbersOf(list);
      const next = numbers.length > 0 ? step(name, numbers) : undefined;
      if (next) whole = composed(whole, next);
      return next ? '' : '?';
    },
  );
  return /^[\s,]*$/.test(rest) && whole.every(Number.isFinite) ? whole : undefined;
}
