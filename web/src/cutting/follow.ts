/** Brings marks of the drafted piece to its solved shape, which shares its triangles and outline. */
import type {Notch} from '../model/garment-marks.js';
import type {Point} from '../model/geometry.js';
import type {ResultPiece} from '../model/result.js';
import {pick} from '../scene/marks.js';

const mix = (p: Point, q: Point, share: number): Point => [
  p[0] + share * (q[0] - p[0]),
  p[1] + share * (q[1] - p[1]),
];

/** A point of the drafted piece as a point of its shape: by the triangle it lies in, or the nearest one. */
export function shapePoint({rest, shape, triangles}: ResultPiece, p: Point): Point {
  let best = -Infinity;
  let at = p;
  for (const triangle of triangles) {
    const [a, b, c] = pick(rest, triangle);
    const [a2, b2, c2] = pick(shape, triangle);
    if (!a || !b || !c || !a2 || !b2 || !c2) continue;
    const area = (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
    const v = ((p[0] - a[0]) * (c[1] - a[1]) - (p[1] - a[1]) * (c[0] - a[0])) / area;
    const w = ((b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0])) / area;
    const inside = Math.min(1 - v - w, v, w);
    if (inside <= best) continue;
    best = inside;
    at = [
      a2[0] + v * (b2[0] - a2[0]) + w * (c2[0] - a2[0]),
      a2[1] + v * (b2[1] - a2[1]) + w * (c2[1] - a2[1]),
    ];
  }
  return at;
}

/** A point of the sewn outline, and the unit vector that leads out of the piece there. */
export interface OutlineMark {
  readonly at: Point;
  readonly outward: Point;
}

/** A notch on the shape's outline. @param notch as the piece lies face up, in its drafted coordinates */
export function notchMark(
  {rest, shape, outline}: ResultPiece,
  {from, to, at}: Notch,
): OutlineMark | undefined {
  const drafted = pick(rest, outline);
  const nearest = ([x, y]: Point): number => {
    const apart = drafted.map((p) => Math.hypot(p[0] - x, p[1] - y));
    return apart.indexOf(Math.min(...apart));
  };
  const first = nearest(from);
  const steps = (nearest(to) - first + outline.length) % outline.length || outline.length;
  const edge = Array.from({length: steps + 1}, (_, k) => (first + k) % outline.length);
  const before = pick(drafted, edge);
  const after = pick(pick(shape, outline), edge);
  const lengths = before.slice(1).map((p, k) => {
    const [x, y] = before[k] ?? p;
    return Math.hypot(p[0] - x, p[1] - y);
  });
  let left = at * lengths.reduce((sum, length) => sum + length, 0);
  for (const [k, length] of lengths.entries()) {
    const [p, q] = after.slice(k, k + 2);
    if (p && q && (left <= length || k === lengths.length - 1)) {
      const along: Point = [q[0] - p[0], q[1] - p[1]];
      const size = Math.hypot(...along);
      return {
        at: mix(p, q, Math.min(1, left / length)),
        outward: [along[1] / size, -along[0] / size],
      };
    }
    left -= length;
  }
  return undefined;
}
