/** A point or vector of the plane. Lengths are centimetres, y points up. */
export type Point = readonly [x: number, y: number];

export const plus = ([ax, ay]: Point, [bx, by]: Point, factor = 1): Point => [
  ax + factor * bx,
  ay + factor * by,
];

export const minus = ([ax, ay]: Point, [bx, by]: Point): Point => [ax - bx, ay - by];

export const dot = (a: Point, b: Point): number => a[0] * b[0] + a[1] * b[1];

/** Area spanned by two vectors, positive when b is counter-clockwise of a. [cm2] */
export const cross = (a: Point, b: Point): number => a[0] * b[1] - a[1] * b[0];

/** Length of a vector. */
export const norm = ([x, y]: Point): number => Math.hypot(x, y);

export const distance = (a: Point, b: Point): number => Math.hypot(a[0] - b[0], a[1] - b[1]);

/** The unit vector in the same direction; the zero vector stays zero. */
export function unit([x, y]: Point): Point {
  const length = Math.hypot(x, y) || 1;
  return [x / length, y / length];
}

/** The point at a share of the way from `a` to `b`. */
export const between = (a: Point, b: Point, share: number): Point => [
  a[0] + share * (b[0] - a[0]),
  a[1] + share * (b[1] - a[1]),
];

export const middle = (a: Point, b: Point): Point => [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2];

/** The share of the way from `a` to `b`, from 0 to 1, at which the point is nearest to `p`. */
export function nearestShare(a: Point, b: Point, p: Point): number {
  const [x, y] = [b[0] - a[0], b[1] - a[1]];
  const share = ((p[0] - a[0]) * x + (p[1] - a[1]) * y) / (x * x + y * y || 1);
  return Math.max(0, Math.min(1, share));
}

/** Turns a vector counter-clockwise by a quarter turn, exactly. */
export const leftOf = ([x, y]: Point): Point => [0 - y, x];

/** Turns a vector counter-clockwise by an angle. [rad] */
export function rotated([x, y]: Point, angle: number): Point {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  return [c * x - s * y, s * x + c * y];
}

/** The unit vector at an angle counter-clockwise of +x. [rad] */
export const towards = (angle: number): Point => [Math.cos(angle), Math.sin(angle)];

/** The direction of a vector, counter-clockwise of +x, in [-pi, pi]. [rad] */
export const angleOf = ([x, y]: Point): number => Math.atan2(y, x);

/** The angle by which `a` must turn to point along `b`, in [-pi, pi]. [rad] */
export const turnBetween = (a: Point, b: Point): number => Math.atan2(cross(a, b), dot(a, b));

/** The same angle in (-pi, pi]. [rad] */
export function wrapped(angle: number): number {
  const turn = angle - 2 * Math.PI * Math.round(angle / (2 * Math.PI));
  return turn <= -Math.PI ? turn + 2 * Math.PI : turn;
}

export const radians = (degrees: number): number => (degrees * Math.PI) / 180;
export const degrees = (radians: number): number => (radians * 180) / Math.PI;

/** The numbers s, t with v = s a + t b. */
export function coordinates([a, b]: readonly [Point, Point], v: Point): Point {
  const area = cross(a, b);
  return [cross(v, b) / area, cross(a, v) / area];
}

/** The vector s a + t b: the inverse of `coordinates`. */
export const combined = ([a, b]: readonly [Point, Point], s: number, t: number): Point => [
  s * a[0] + t * b[0],
  s * a[1] + t * b[1],
];

/**
 * Place of a piece on the print: p = R(angle) w + translation, w a point of the print. [rad, cm]
 */
export interface Alignment {
  readonly angle: number;
  readonly translation: Point;
}

/** Converts alignments from a solve's progress: angle, x and y per piece. */
export const alignmentsFrom = (numbers: Float64Array): readonly Alignment[] =>
  Array.from({length: Math.floor(numbers.length / 3)}, (_, k) => {
    const [angle = 0, x = 0, y = 0] = numbers.subarray(3 * k, 3 * k + 3);
    return {angle, translation: [x, y]};
  });

/**
 * Map of a piece to its mirror image, itself or its twin, face up: p' = R(angle) F p + translation,
 * F = diag(-1, 1). [rad, cm]
 */
export interface MirrorMap {
  readonly angle: number;
  readonly translation: Point;
}

/** The point of the print under a point p of a piece: w = R(angle)^T (p - translation). */
export const onPrint = ({angle, translation}: Alignment, p: Point): Point =>
  rotated(minus(p, translation), -angle);

/** The point of a piece on a point w of the print: p = R(angle) w + translation. */
export const onPiece = ({angle, translation}: Alignment, w: Point): Point =>
  plus(rotated(w, angle), translation);

/** The alignment with this angle that puts a point of a piece on a point of the print. */
export const lyingOn = (angle: number, p: Point, print: Point): Alignment => ({
  angle,
  translation: minus(p, rotated(print, angle)),
});
