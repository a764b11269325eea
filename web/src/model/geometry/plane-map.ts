/** Affine maps of the plane. */
import {radians, type Point} from './vectors.js';

/** The map x -> A x + a, with A = [[xx, xy], [yx, yy]]. */
export interface PlaneMap {
  readonly xx: number;
  readonly xy: number;
  readonly yx: number;
  readonly yy: number;
  readonly shift: Point;
}

export const planeMap = (
  xx: number,
  xy: number,
  yx: number,
  yy: number,
  x = 0,
  y = 0,
): PlaneMap => ({
  xx,
  xy,
  yx,
  yy,
  shift: [x, y],
});

export const identity = planeMap(1, 0, 0, 1);
export const shifting = (x: number, y: number): PlaneMap => planeMap(1, 0, 0, 1, x, y);
export const scaling = (x: number, y = x): PlaneMap => planeMap(x, 0, 0, y);

/** Turns counterclockwise where y points up. */
export function turning(degrees: number): PlaneMap {
  const [c, s] = [Math.cos(radians(degrees)), Math.sin(radians(degrees))];
  return planeMap(c, -s, s, c);
}

/** The map that applies `inner` first, then `outer`. */
export function after(outer: PlaneMap, inner: PlaneMap): PlaneMap {
  const [x, y] = apply(outer, inner.shift);
  return planeMap(
    outer.xx * inner.xx + outer.xy * inner.yx,
    outer.xx * inner.xy + outer.xy * inner.yy,
    outer.yx * inner.xx + outer.yy * inner.yx,
    outer.yx * inner.xy + outer.yy * inner.yy,
    x,
    y,
  );
}

export const apply = ({xx, xy, yx, yy, shift}: PlaneMap, [x, y]: Point): Point => [
  xx * x + xy * y + shift[0],
  yx * x + yy * y + shift[1],
];

export const determinant = ({xx, xy, yx, yy}: PlaneMap): number => xx * yy - xy * yx;
