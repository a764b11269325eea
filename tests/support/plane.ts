/** Vectors of the plane, for the checks of results. */
import type {Alignment, Point} from 'seamwise/node';

export const add = (a: Point, b: Point): Point => [a[0] + b[0], a[1] + b[1]];
export const sub = (a: Point, b: Point): Point => [a[0] - b[0], a[1] - b[1]];
export const scale = (a: Point, s: number): Point => [a[0] * s, a[1] * s];
export const dot = (a: Point, b: Point): number => a[0] * b[0] + a[1] * b[1];
export const cross = (a: Point, b: Point): number => a[0] * b[1] - a[1] * b[0];
export const distance = (a: Point, b: Point): number => Math.hypot(a[0] - b[0], a[1] - b[1]);
export const middle = (a: Point, b: Point): Point => scale(add(a, b), 0.5);
export const turned = ([x, y]: Point, angle: number): Point => [
  Math.cos(angle) * x - Math.sin(angle) * y,
  Math.sin(angle) * x + Math.cos(angle) * y,
];
/** The angle by which `a` must turn to point along `b`, in (-pi, pi]. */
export const turn = (a: Point, b: Point): number => Math.atan2(cross(a, b), dot(a, b));

/** A point of a piece as a point of the print. */
export const onPrint = ({angle, translation}: Alignment, p: Point): Point =>
  turned(sub(p, translation), -angle);

/** Eq. 3: p' = R F p + t with F = diag(-1, 1). */
export const mirrored = ({angle, translation}: Alignment, [x, y]: Point): Point =>
  add(turned([-x, y], angle), translation);

/** The element at `index`, which must exist; negative indices count from the end. */
export function at<T>(list: readonly T[], index: number): T {
  const value = list.at(index);
  if (value === undefined) throw new RangeError(`no element ${index} of ${list.length}`);
  return value;
}

/** Each element with its successor around the loop. */
export const aroundLoop = <T>(loop: readonly T[]): [T, T][] =>
  loop.map((v, k) => [v, at(loop, (k + 1) % loop.length)]);

/** Each element with its successor along the line. */
export const alongLine = <T>(line: readonly T[]): [T, T][] =>
  line.slice(1).map((v, k) => [at(line, k), v]);

export const sum = (values: readonly number[]): number => values.reduce((s, v) => s + v, 0);
/** Zero for an empty list, unlike Math.max. */
export const greatest = (values: readonly number[]): number =>
  values.reduce((m, v) => Math.max(m, v), 0);
