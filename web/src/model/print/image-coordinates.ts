import {apply, determinant, type PlaneMap} from '../geometry/plane-map.js';
import {minus, type Alignment, type Point} from '../geometry/vectors.js';
import type {Print} from './repeating-print.js';
import {imageCell} from './wallpaper.js';

/**
 * Maps points of a piece to coordinates of the print's image: (0, 0) is the lower left corner of
 * one cell, (1, 1) its upper right. The coordinates of `near` are within the first cell, where
 * single precision is finest; whole cells do not affect the image.
 */
export function imageCoordinates(
  print: Print,
  {angle, translation}: Alignment,
  near: Point,
): PlaneMap {
  const [a, b] = imageCell(print);
  const d = determinant({xx: a[0], xy: b[0], yx: a[1], yy: b[1], shift: [0, 0]});
  const c = Math.cos(angle);
  const s = Math.sin(angle);
  // (a b)^-1 R^T
  const map: PlaneMap = {
    xx: (b[1] * c + b[0] * s) / d,
    xy: (b[1] * s - b[0] * c) / d,
    yx: (-a[1] * c - a[0] * s) / d,
    yy: (a[0] * c - a[1] * s) / d,
    shift: [0, 0],
  };
  const at = (p: Point): Point => apply(map, minus(p, translation));
  const [u, v] = at([0, 0]);
  const first = at(near);
  return {...map, shift: [u - Math.floor(first[0]), v - Math.floor(first[1])]};
}
