/**
 * Finds the piece or seam of a drape under the pointer, and the direction from which it is best
 * visible.
 */
import type {Surface} from '../../model/result/draped-garment.js';
import type {Point} from '../../model/geometry/vectors.js';
import type {ScreenSize} from '../../scene/sheet-view.js';
import {eyeOf, fieldOfView, screenAxes, wayOut, type Orbit} from './camera.js';
import type {ClothLayer} from './cloth-layer.js';
import {firstHit, nearestSeam, type Ray} from './pick.js';
import {seamVertices} from './ribbons.js';
import {dot3, minus3, plus3, pointOf, unit3, type Vector} from './space.js';

export type DrapeTarget =
  | {readonly kind: 'piece'; readonly piece: number}
  | {readonly kind: 'seam'; readonly seam: number; readonly side: 'a' | 'b'};

interface Look {
  readonly layer: ClothLayer;
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
  facing({cloth, normals}: ClothLayer, target: DrapeTarget): Vector {
    const vertices =
      target.kind === 'seam'
        ? seamVertices(cloth.mesh)[target.seam]
        : cloth.mesh.pieces[target.piece]?.sewn;
    let sum: Vector = [0, 0, 0];
    for (const vertex of vertices ?? []) sum = plus3(sum, pointOf(normals, vertex));
    return unit3(sum);
  }
}
