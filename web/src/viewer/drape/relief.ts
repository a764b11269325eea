/** Features of a drape's fabric that only its drawing needs: open edges, hems and folds. */
import {between, distance, nearestShare, type Point} from '../../model/geometry/vectors.js';
import type {DrapeMesh, DrapedPiece} from '../../model/result/draped-garment.js';

/** An edge that is sewn to nothing, such as a hem: two vertices of a piece. */
export interface OpenEdge {
  readonly piece: number;
  readonly from: number;
  readonly to: number;
  /** Length of the piece's outline before the edge. [cm] */
  readonly run: number;
}

/** Returns the edges of all outlines that no seam joins. */
export function openEdges({pieces, seams}: DrapeMesh): readonly OpenEdge[] {
  const key = (piece: number, a: number, b: number): string =>
    `${piece} ${Math.min(a, b)} ${Math.max(a, b)}`;
  const sewn = new Set<string>();
  for (const {a, b} of seams)
    for (const {piece, vertices} of [a, b])
      for (let k = 1; k < vertices.length; k++)
        sewn.add(key(piece, vertices[k - 1] ?? 0, vertices[k] ?? 0));
  return pieces.flatMap(({outline, shape}, piece) => {
    const open: OpenEdge[] = [];
    let run = 0;
    for (const [k, from] of outline.entries()) {
      const to = outline[(k + 1) % outline.length] ?? 0;
      if (!sewn.has(key(piece, from, to))) open.push({piece, from, to, run});
      run += distance(pointAt(shape, from), pointAt(shape, to));
    }
    return open;
  });
}

/** Farther from an edge there is no hem. [cm] */
export const hemReach = 4;

/**
 * Returns the distance of each vertex of a piece to the nearest open edge, at most `hemReach`, and
 * the place along the outline that is nearest. [cm]
 */
export function hemPlaces({shape}: DrapedPiece, open: readonly OpenEdge[]): Float32Array {
  const places = new Float32Array(shape.length);
  for (let k = 0; k < shape.length; k += 2) places[k] = hemReach;
  for (const {from, to, run} of open) {
    const [a, b] = [pointAt(shape, from), pointAt(shape, to)];
    const length = distance(a, b);
    const reach = length + hemReach;
    for (let k = 0; k < shape.length; k += 2) {
      const p = pointAt(shape, k / 2);
      if (Math.abs(p[0] - a[0]) > reach || Math.abs(p[1] - a[1]) > reach) continue;
      const share = nearestShare(a, b, p);
      const off = distance(p, between(a, b, share));
      if (off < (places[k] ?? 0)) places.set([off, run + share * length], k);
    }
  }
  return places;
}

/** Keeps a vertex without a triangle at 0. [cm] */
const tiny = 1e-9;

/**
 * Computes how hollow the fabric is at each vertex of the mesh: the height of the neighbours' mean
 * above it, along its normal, over their mean distance. Folds are positive in their depth and
 * negative on their ridge.
 */
export function hollows(
  positions: ArrayLike<number>,
  normals: ArrayLike<number>,
  triangles: Uint32Array,
  into: Float32Array,
): void {
  const reach = new Float32Array(into.length);
  into.fill(0);
  for (let k = 0; k < triangles.length; k++) {
    const at = triangles[k] ?? 0;
    const first = k - (k % 3);
    for (const other of [
      triangles[first + ((k + 1) % 3)] ?? 0,
      triangles[first + ((k + 2) % 3)] ?? 0,
    ]) {
      const x = (positions[3 * other] ?? 0) - (positions[3 * at] ?? 0);
      const y = (positions[3 * other + 1] ?? 0) - (positions[3 * at + 1] ?? 0);
      const z = (positions[3 * other + 2] ?? 0) - (positions[3 * at + 2] ?? 0);
      const height =
        x * (normals[3 * at] ?? 0) +
        y * (normals[3 * at + 1] ?? 0) +
        z * (normals[3 * at + 2] ?? 0);
      into[at] = (into[at] ?? 0) + height;
      reach[at] = (reach[at] ?? 0) + Math.sqrt(x * x + y * y + z * z);
    }
  }
  for (let k = 0; k < into.length; k++) into[k] = (into[k] ?? 0) / Math.max(tiny, reach[k] ?? 0);
}

const pointAt = (points: ArrayLike<number>, k: number): Point => [
  points[2 * k] ?? 0,
  points[2 * k + 1] ?? 0,
];
