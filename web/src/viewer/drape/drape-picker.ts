/**
 * Finds the piece or seam of a drape under the pointer, and the direction from which it is best
 * visible.
 */
import type {Surface} from '../../model/result/draped-garment.js';
import type {Point} from '../../model/geometry/vectors.js';
import type {ScreenSize} from '../../scene/sheet-view.js';
import {eyeOf, fieldOfView, screenAxes, wayOut, type Orbit} from './camera.js';
import type {FabricLayer} from './cloth-layer.js';
import {seamVertices} from './ribbons.js';
import {dot3, minus3, plus3, pointOf, unit3, type Vector} from './space.js';

export type DrapeTarget =
  | {readonly kind: 'piece'; readonly piece: number}
  | {readonly kind: 'seam'; readonly seam: number; readonly side: 'a' | 'b'};

interface Look {
  readonly layer: FabricLayer;
  readonly orbit: Orbit;
  readonly size: ScreenSize;
  /** Hides the garment behind it. */
  readonly form: Surface | undefined;
  /** [CSS px] */
  readonly reach: number;
}

/** Returns the ray from the eye through a point of a picture. [CSS px] */
export function rayThrough([x, y]: Point, orbit: Orbit, {width, height}: ScreenSize): Ray {
  const tangent = Math.tan(fieldOfView / 2);
  const [right, up] = screenAxes(orbit);
  const sideways = ((2 * x) / width - 1) * tangent * (width / height);
  const upwards = (1 - (2 * y) / height) * tangent;
  const ahead = plus3([0, 0, 0], wayOut(orbit), -1);
  const way = plus3(plus3(ahead, right, sideways), up, upwards);
  return {origin: eyeOf(orbit), way: unit3(way)};
}

/**
 * Projects a point in space onto the picture [CSS px], with its distance from the eye [cm]; the
 * inverse of `rayThrough`.
 */
export function projected(
  point: Vector,
  orbit: Orbit,
  {width, height}: ScreenSize,
): {readonly at: Point; readonly distance: number} {
  const from = minus3(point, eyeOf(orbit));
  const [right, up] = screenAxes(orbit);
  const ahead = -dot3(from, wayOut(orbit));
  const scale = height / 2 / Math.tan(fieldOfView / 2) / ahead;
  return {
    at: [width / 2 + dot3(from, right) * scale, height / 2 - dot3(from, up) * scale],
    distance: Math.hypot(...from),
  };
}

export class DrapePicker {
  at(at: Point, {layer, orbit, size, form, reach}: Look): DrapeTarget | undefined {
    const {cloth, positions} = layer;
    const ray = rayThrough(at, orbit, size);
    const hit = firstHit(ray, positions, cloth.welded);
    if (!hit) return undefined;
    const body = form && firstHit(ray, form.vertices, form.triangles);
    if (body && body.distance < hit.distance) return undefined;
    const lines = seamVertices(cloth.mesh).map((vertices, seam) => ({seam, vertices}));
    const project = (point: Vector) => projected(point, orbit, size);
    const seam = nearestSeam(lines, positions, at, hit, reach, project);
    const piece = cloth.pieces[cloth.triangles[3 * hit.triangle] ?? 0] ?? 0;
    if (seam === undefined) return {kind: 'piece', piece};
    const side = cloth.mesh.seams[seam]?.b.piece === piece ? 'b' : 'a';
    return {kind: 'seam', seam, side};
  }

  /** Returns the mean direction that a target's surface faces. */
  facing({cloth, normals}: FabricLayer, target: DrapeTarget): Vector {
    const vertices =
      target.kind === 'seam'
        ? seamVertices(cloth.mesh)[target.seam]
        : cloth.mesh.pieces[target.piece]?.sewn;
    let sum: Vector = [0, 0, 0];
    for (const vertex of vertices ?? []) sum = plus3(sum, pointOf(normals, vertex));
    return unit3(sum);
  }
}

/** Finds the triangle and the seam under a point of a drape's picture. */
interface Ray {
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
