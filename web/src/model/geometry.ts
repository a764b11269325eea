/** A point or vector of the plane. Lengths are centimetres, y points up. */
export type Point = readonly [x: number, y: number];

/** Where a piece lies on the print: p = R(angle) w + translation, w a point of the print. [rad, cm] */
export interface Alignment {
  readonly angle: number;
  readonly translation: Point;
}

/** Whether the way from one point to another crosses the ray that runs from a third to the right. */
export const crossesRay = ([ax, ay]: Point, [bx, by]: Point, [x, y]: Point): boolean =>
  ay > y !== by > y && x < ax + ((y - ay) / (by - ay)) * (bx - ax);
