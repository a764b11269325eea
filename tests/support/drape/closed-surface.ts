/** Inside test of a closed surface, with the depth. */
import type {Corners, Place} from '@/model/documents/drape-file.js';
import {at} from '../plane.js';
import {Cells, toTriangle} from './space.js';

/** Cell size of the grid in which triangles are looked up. [cm] */
const cell = 1;

export class ClosedSurface {
  readonly #triangles: readonly (readonly [Place, Place, Place])[];
  /** Indexes of triangles by their position, and by their neighbours along x. */
  readonly #near: Cells;
  readonly #beside: Cells;

  constructor(surface: {
    readonly vertices: readonly Place[];
    readonly triangles: readonly Corners[];
  }) {
    this.#triangles = surface.triangles.map(([a, b, c]) => [
      at(surface.vertices, a),
      at(surface.vertices, b),
      at(surface.vertices, c),
    ]);
    this.#near = new Cells(this.#triangles, cell);
    this.#beside = new Cells(this.#triangles.map(flat), cell);
  }

  /**
   * The winding number about a point: 1 inside, 0 outside. Counts the triangles that a ray along x
   * crosses, with their signs. A ray through an edge counts as passing just beside it, on the same
   * side for both triangles.
   */
  winding(p: Place): number {
    let count = 0;
    for (const k of this.#beside.near([[0, p[1], p[2]]])) {
      const [a, b, c] = at(this.#triangles, k);
      let turns = 0;
      const corners = [a, b, c, a];
      for (let i = 0; i < 3; i++) {
        const [from, to] = [at(corners, i), at(corners, i + 1)];
        if (from[1] > p[1] === to[1] > p[1]) continue;
        const [low, high] = from[1] < to[1] ? [from, to] : [to, from]; // equal for both triangles
        const z = low[2] + ((high[2] - low[2]) * (p[1] - low[1])) / (high[1] - low[1]);
        if (z > p[2]) turns += to[1] < from[1] ? 1 : -1;
      }
      if (turns !== 0 && crossing([a, b, c], p) > p[0]) count += turns;
    }
    return count;
  }

  /** Signed distance, negative inside; limited to 1 cm from the surface. [cm] */
  distance(p: Place): number {
    let least = cell;
    for (const k of this.#near.near([p], cell)) {
      least = Math.min(least, toTriangle(at(this.#triangles, k), p));
    }
    return this.winding(p) > 0 ? -least : least;
  }
}

/** Number of edges that are not shared by exactly two triangles, once in each direction. */
export function openEdges(triangles: readonly Corners[]): number {
  const seen = new Set<string>();
  let faults = 0;
  for (const [a, b, c] of triangles) {
    for (const edge of [`${a},${b}`, `${b},${c}`, `${c},${a}`]) {
      if (seen.has(edge)) faults++;
      seen.add(edge);
    }
  }
  for (const edge of seen) if (!seen.has(edge.split(',').reverse().join())) faults++;
  return faults;
}

const flat = (points: readonly Place[]): readonly Place[] =>
  points.map(([, y, z]): Place => [0, y, z]);

/** Intersection of the line through `p` along x with the plane of a triangle. */
function crossing([a, b, c]: readonly [Place, Place, Place], p: Place): number {
  const [uy, uz, vy, vz] = [b[1] - a[1], b[2] - a[2], c[1] - a[1], c[2] - a[2]];
  const area = uy * vz - uz * vy;
  const [py, pz] = [p[1] - a[1], p[2] - a[2]];
  const s = (py * vz - pz * vy) / area;
  const t = (uy * pz - uz * py) / area;
  return a[0] + s * (b[0] - a[0]) + t * (c[0] - a[0]);
}
