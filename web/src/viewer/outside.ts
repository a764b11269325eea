/** Lines along the edge of a piece that lie outside of it, so that they hide nothing of the print. */
import {minus, norm, plus, unit, type Point} from '../model/geometry.js';
import {crossingsOf} from '../model/polyline.js';
import type {ScenePiece} from '../scene/scene.js';

/** Of its width, that a line is moved off the edge: it still covers where the cloth ends in steps of pixels. */
const offEdge = 0.42;
/** At a sharp corner a line stays this near. */
const longestCorner = 2;

/** For every vertex of the outline or of a cut-out the one after it. */
const followers = new WeakMap<readonly number[], ReadonlyMap<number, number>>();

function followersOn({
  outline,
  holes,
}: Pick<ScenePiece, 'outline' | 'holes'>): ReadonlyMap<number, number> {
  const known = followers.get(outline);
  if (known) return known;
  const loops = [outline, ...holes];
  const next = new Map(
    loops.flatMap((loop) => loop.map((v, k) => [v, loop[(k + 1) % loop.length] ?? v] as const)),
  );
  followers.set(outline, next);
  return next;
}

/** 1 where the piece has its outside on the right of somebody who walks these vertices, -1 on the left. */
export function outsideOf(
  piece: Pick<ScenePiece, 'outline' | 'holes'> | undefined,
  [first = -1, second = -1]: readonly number[],
): 1 | -1 {
  return piece && followersOn(piece).get(first) !== second ? -1 : 1;
}

/** Unit vectors to the right of every edge. */
const rights = (points: readonly Point[], closed: boolean): readonly Point[] =>
  points.slice(closed ? 0 : 1).map(([x, y], k): Point => {
    const [from, to] = closed
      ? [[x, y] as const, points[(k + 1) % points.length] ?? [x, y]]
      : [points[k] ?? [x, y], [x, y] as const];
    return unit([to[1] - from[1], from[0] - to[0]]);
  });

/** What moves a line to the outside, per point; in widths of the line. */
export function shiftsOutside(points: readonly Point[], side: 1 | -1, closed = false): Point[] {
  const normals = rights(points, closed);
  const last = normals.length - 1;
  return points.map((_, k): Point => {
    const before = normals[k === 0 ? (closed ? last : 0) : k - 1] ?? [0, 0];
    const after = normals[Math.min(k, last)] ?? before;
    const [x, y] = plus(before, after);
    // both edges are left by the same distance
    const stretch = Math.min(
      2 / Math.max(x * x + y * y, 1e-6),
      longestCorner / (norm([x, y]) || 1),
    );
    return [side * offEdge * stretch * x, side * offEdge * stretch * y];
  });
}

/** Where the line through two points first enters and last leaves the cloth, and the way on from there. */
export function endsOnOutline(
  {points, outline}: Pick<ScenePiece, 'points' | 'outline'>,
  [from, to]: readonly [Point, Point],
): readonly {readonly at: Point; readonly out: Point}[] {
  const along = unit(minus(to, from));
  const crossings = crossingsOf(
    outline.flatMap((v) => points.slice(v, v + 1)),
    from,
    along,
  );
  if (crossings.length === 0) return [];
  const end = (way: number, sense: 1 | -1): {at: Point; out: Point} => ({
    at: plus(from, along, way),
    out: [sense * along[0], sense * along[1]],
  });
  return [end(Math.min(...crossings), -1), end(Math.max(...crossings), 1)];
}
