/** Where symmetries are marked on a piece. Lengths in cm, y up. */
import {crossesRay, type Alignment, type Point} from '../model/geometry.js';
import {onPrint} from './mismatch.js';

export const pick = (points: readonly Point[], vertices: readonly number[]): Point[] =>
  vertices.flatMap((v) => points.slice(v, v + 1));

/** The mirror axis along the given points and `overhang` beyond them. p' = R F p + t mirrors in a line through t / 2. */
export function axisAlong(
  {angle, translation}: Alignment,
  points: readonly Point[],
  overhang: number,
): readonly [Point, Point] {
  const direction: Point = [-Math.sin(angle / 2), Math.cos(angle / 2)];
  const [mx, my] = [translation[0] / 2, translation[1] / 2];
  const along = points.map(([x, y]) => (x - mx) * direction[0] + (y - my) * direction[1]);
  const at = (s: number): Point => [mx + s * direction[0], my + s * direction[1]];
  return [at(Math.min(...along) - overhang), at(Math.max(...along) + overhang)];
}

/** The mirror image p' = R F p + t of a point. */
export function mirrorImage({angle, translation}: Alignment, [x, y]: Point): Point {
  const turned = onPrint({angle: -angle, translation: [0, 0]}, [-x, y]);
  return [turned[0] + translation[0], turned[1] + translation[1]];
}

/** The point of a piece that lies furthest from its outline, and from what else is in the way, on a coarse grid; and how far that is. */
export function innermost(
  points: readonly Point[],
  obstacles: readonly Point[] = [],
): {readonly at: Point; readonly room: number} {
  const xs = points.map(([x]) => x);
  const ys = points.map(([, y]) => y);
  const [left, right, low, high] = [
    Math.min(...xs),
    Math.max(...xs),
    Math.min(...ys),
    Math.max(...ys),
  ];
  let at: Point = [(left + right) / 2, (low + high) / 2];
  let room = 0;
  const n = 24;
  const inTheWay = [...points, ...obstacles];
  for (let i = 1; i < n; i++) {
    for (let j = 1; j < n; j++) {
      const p: Point = [left + ((right - left) * i) / n, low + ((high - low) * j) / n];
      const free = distance(inTheWay, p, room);
      if (free > room + 1e-6 && isInside(points, p)) [at, room] = [p, free];
    }
  }
  return {at, room};
}

/** From a point to the nearest of others; 0 as soon as it is known to be no more than `least`. */
function distance(points: readonly Point[], [px, py]: Point, least: number): number {
  let nearest = Infinity;
  for (const [x, y] of points) {
    nearest = Math.min(nearest, (x - px) ** 2 + (y - py) ** 2);
    if (nearest <= least * least) return 0;
  }
  return Math.sqrt(nearest);
}

/** Whether a closed outline goes round a point. */
export const isInside = (outline: readonly Point[], point: Point): boolean =>
  outline.reduce(
    (odd, from, k) => crossesRay(from, outline[(k + 1) % outline.length] ?? from, point) !== odd,
    false,
  );
