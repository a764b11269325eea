/**
 * Shifts lines along the edge of a piece to its outside, so that they hide nothing of the print.
 */
import {minus, norm, plus, unit, type Point} from '../model/geometry/vectors.js';
import {crossingsOf} from '../model/geometry/polyline.js';
import type {ScenePiece} from '../scene/scene.js';

/**
 * Share of a line's width by which it moves off the edge: it still covers the fabric's jagged
 * pixels.
 */
const offEdge = 0.42;
/** Greatest shift at a sharp corner, as a multiple of the usual shift. */
const longestCorner = 2;

/** For each vertex of the outline or of a cut-out, the next one. */
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

/**
 * Returns 1 if the piece's outside is on the right along these vertices, -1 if it is on the left.
 */
export function outsideOf(
  piece: Pick<ScenePiece, 'outline' | 'holes'> | undefined,
  [first = -1, second = -1]: readonly number[],
): 1 | -1 {
  return piece && followersOn(piece).get(first) !== second ? -1 : 1;
}

/** Returns unit vectors to the right of each edge. */
const rights = (points: readonly Point[], closed: boolean): readonly Point[] =>
  points.slice(closed ? 0 : 1).map(([x, y], k): Point => {
    const [from, to] = closed
      ? [[x, y] as const, points[(k + 1) % points.length] ?? [x, y]]
      : [points[k] ?? [x, y], [x, y] as const];
    return unit([to[1] - from[1], from[0] - to[0]]);
  });

/** Returns each point's shift to the outside, in widths of the line. */
export function shiftsOutside(points: readonly Point[], side: 1 | -1, closed = false): Point[] {
  const normals = rights(points, closed);
  const last = normals.length - 1;
  return points.map((_, k): Point => {
    const before = normals[k === 0 ? (closed ? last : 0) : k - 1] ?? [0, 0];
    const after = normals[Math.min(k, last)] ?? before;
    const [x, y] = plus(before, after);
    // the distance to both edges is the same
    const stretch = Math.min(
      2 / Math.max(x * x + y * y, 1e-6),
      longestCorner / (norm([x, y]) || 1),
    );
    return [side * offEdge * stretch * x, side * offEdge * stretch * y];
  });
}

/**
 * Returns the first and the last crossing of the line through two points with the outline, and the
 * direction outwards.
 */
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
