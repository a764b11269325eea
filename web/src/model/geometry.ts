/** A point or vector of the plane. Lengths are centimetres, y points up. */
export type Point = readonly [x: number, y: number];

export const minus = ([ax, ay]: Point, [bx, by]: Point): Point => [ax - bx, ay - by];

export const dot = (a: Point, b: Point): number => a[0] * b[0] + a[1] * b[1];

/** Positive when b is counter-clockwise of a: the area that they span. [cm2] */
export const cross = (a: Point, b: Point): number => a[0] * b[1] - a[1] * b[0];

export const distance = (a: Point, b: Point): number => Math.hypot(a[0] - b[0], a[1] - b[1]);

/** Of length 1; no direction stays none. */
export function unit([x, y]: Point): Point {
  const length = Math.hypot(x, y) || 1;
  return [x / length, y / length];
}

/** Counter-clockwise. [rad] */
export function rotated([x, y]: Point, angle: number): Point {
  const [c, s] = [Math.cos(angle), Math.sin(angle)];
  return [c * x - s * y, s * x + c * y];
}

/** Where a piece lies on the print: p = R(angle) w + translation, w a point of the print. [rad, cm] */
export interface Alignment {
  readonly angle: number;
  readonly translation: Point;
}

/** Whether the way from one point to another crosses the ray that runs from a third to the right. */
export const crossesRay = ([ax, ay]: Point, [bx, by]: Point, [x, y]: Point): boolean =>
  ay > y !== by > y && x < ax + ((y - ay) / (by - ay)) * (bx - ax);
