/** Finds the triangle and the seam under a point of a drape's picture. */
import type {Point} from '../../model/geometry/vectors.js';
import {pointOf, type Vector} from './space.js';

export interface Ray {
  readonly origin: Vector;
  /** Unit vector. */
  readonly way: Vector;
}

/** First intersection of a ray with a triangle of a surface, from either side. */
interface Hit {
  readonly triangle: number;
  readonly distance: number;
}

/**
 * Returns the first hit (Möller and Trumbore 1997).
 * @param positions x, y, z per vertex
 * @param triangles three vertices per triangle
 */
export function firstHit(
  {origin, way}: Ray,
  positions: ArrayLike<number>,
  triangles: ArrayLike<number>,
): Hit | undefined {
  // written out: this runs over all triangles at each move of the pointer
  const [ox, oy, oz] = origin;
  const [wx, wy, wz] = way;
  let best: Hit | undefined;
  let least = Infinity;
  for (let k = 0; k < triangles.length; k += 3) {
    const [a, b, c] = [
      3 * (triangles[k] ?? 0),
      3 * (triangles[k + 1] ?? 0),
      3 * (triangles[k + 2] ?? 0),
    ];
    const [x, y, z] = [positions[a] ?? 0, positions[a + 1] ?? 0, positions[a + 2] ?? 0];
    const [ux, uy, uz] = [
      (positions[b] ?? 0) - x,
      (positions[b + 1] ?? 0) - y,
      (positions[b + 2] ?? 0) - z,
    ];
    const [vx, vy, vz] = [
      (positions[c] ?? 0) - x,
      (positions[c + 1] ?? 0) - y,
      (positions[c + 2] ?? 0) - z,
    ];
    const [px, py, pz] = [wy * vz - wz * vy, wz * vx - wx * vz, wx * vy - wy * vx];
    const volume = ux * px + uy * py + uz * pz;
    if (volume === 0) continue;
    const [fx, fy, fz] = [ox - x, oy - y, oz - z];
    const first = (fx * px + fy * py + fz * pz) / volume;
    if (!(first >= 0 && first <= 1)) continue;
    const [qx, qy, qz] = [fy * uz - fz * uy, fz * ux - fx * uz, fx * uy - fy * ux];
    const second = (wx * qx + wy * qy + wz * qz) / volume;
    if (!(second >= 0 && first + second <= 1)) continue;
    const distance = (vx * qx + vy * qy + vz * qz) / volume;
    if (distance <= 0 || distance >= least) continue;
    least = distance;
    best = {triangle: k / 3, distance};
  }
  return best;
}

/** A line on the mesh that the pointer can select. */
interface PickLine {
  readonly seam: number;
  /** Vertices of the mesh. */
  readonly vertices: Iterable<number>;
}

/**
 * Depth behind the fabric under the pointer from which a seam is on the other side of the garment.
 * [cm]
 */
const seamDepth = 1.5;

/**
 * Returns the seam that passes nearest to a point of the picture, at most `reach` px away.
 * @param project returns a point's place in the picture [px] and its distance from the eye [cm]
 */
export function nearestSeam(
  lines: readonly PickLine[],
  positions: ArrayLike<number>,
  at: Point,
  hit: Hit,
  reach: number,
  project: (point: Vector) => {readonly at: Point; readonly distance: number},
): number | undefined {
  let best: {readonly seam: number; readonly away: number} | undefined;
  for (const {seam, vertices} of lines) {
    let before: {readonly at: Point; readonly distance: number} | undefined;
    for (const vertex of vertices) {
      const next = project(pointOf(positions, vertex));
      if (before && Math.abs((before.distance + next.distance) / 2 - hit.distance) < seamDepth) {
        const away = distanceToSegment(at, before.at, next.at);
        if (away <= reach && away < (best?.away ?? Infinity)) best = {seam, away};
      }
      before = next;
    }
  }
  return best?.seam;
}

function distanceToSegment([x, y]: Point, a: Point, b: Point): number {
  const [dx, dy] = [b[0] - a[0], b[1] - a[1]];
  const share = ((x - a[0]) * dx + (y - a[1]) * dy) / (dx * dx + dy * dy || 1);
  const part = Math.min(1, Math.max(0, share));
  return Math.hypot(x - a[0] - part * dx, y - a[1] - part * dy);
}
