/**
 * Points that move with the triangles of a piece, from its drafted to its solved state. Lengths in
 * cm.
 */
import {combined, coordinates, minus, plus, type Point} from './vectors.js';

type Triangle = readonly [number, number, number];

/**
 * A point of a triangulated piece after its vertices have moved. It keeps its place in the triangle
 * that contains it, or in the nearest one.
 * @param from vertices before
 * @param to vertices after: one for one, with the same triangles
 */
export function carried(
  triangles: readonly Triangle[],
  from: readonly Point[],
  to: readonly Point[],
  point: Point,
): Point {
  let inmost = -Infinity;
  let at = point;
  for (const [i, j, k] of triangles) {
    const [a, b, c] = [from[i], from[j], from[k]];
    const [a2, b2, c2] = [to[i], to[j], to[k]];
    if (!a || !b || !c || !a2 || !b2 || !c2) continue;
    const [s, t] = coordinates([minus(b, a), minus(c, a)], minus(point, a));
    const least = Math.min(1 - s - t, s, t); // negative outside of the triangle
    if (!(least > inmost)) continue;
    inmost = least;
    at = plus(a2, combined([minus(b2, a2), minus(c2, a2)], s, t));
  }
  return at;
}
