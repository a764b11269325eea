/** A point or vector of the plane. Lengths are centimetres, y points up. */
export type Point = readonly [x: number, y: number];

/** Where a piece lies on the print: p = R(angle) w + translation, w a point of the print. [rad, cm] */
export interface Alignment {
  readonly angle: number;
  readonly translation: Point;
}
