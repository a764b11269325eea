/** A drape file's pieces, sewn to one fabric by its seams. */
import type {Corners, DrapeFile, Place} from '@/model/documents/drape-file.js';
import type {Point} from '@/model/geometry/vectors.js';
import {at} from '../plane.js';
import {Cells, cross3, distance3, dot3, minus3} from './space.js';

export interface ClothTriangle {
  readonly piece: number;
  /** Numbers of its corners in the piece, and in the fabric. */
  readonly vertices: Corners;
  readonly corners: Corners;
  /** Positions of its corners on the piece as cut, and in space. [cm] */
  readonly cut: readonly [Point, Point, Point];
  readonly worn: readonly [Place, Place, Place];
}

/** Merges the vertices that seams join, through any chain of them. */
export class SewnCloth {
  readonly places: readonly Place[];
  readonly triangles: readonly ClothTriangle[];
  readonly #first: readonly number[];
  readonly #parent: number[];

  constructor({pieces, seams}: Pick<DrapeFile, 'pieces' | 'seams'>) {
    let count = 0;
    this.#first = pieces.map(({positions}) => (count += positions.length) - positions.length);
    this.#parent = Array.from({length: count}, (_, k) => k);
    for (const {a, b} of seams) {
      a.vertices.forEach((vertex, k) => {
        const other = this.#root(at(this.#first, b.piece) + at(b.vertices, k));
        this.#parent[this.#root(at(this.#first, a.piece) + vertex)] = other;
      });
    }
    this.places = pieces.flatMap(({positions}) => positions);
    this.triangles = pieces.flatMap(({shape, positions, triangles}, piece) =>
      triangles.map((vertices) => {
        const each = <T>(of: (vertex: number) => T) => vertices.map(of) as [T, T, T];
        return {
          piece,
          vertices,
          corners: each((vertex) => this.vertex(piece, vertex)),
          cut: each((vertex) => at(shape, vertex)),
          worn: each((vertex) => at(positions, vertex)),
        };
      }),
    );
  }

  /** The number in the fabric of a piece's vertex. */
  vertex(piece: number, vertex: number): number {
    return this.#root(at(this.#first, piece) + vertex);
  }

  #root(vertex: number): number {
    let root = vertex;
    for (let next = at(this.#parent, root); next !== root; next = at(this.#parent, root)) {
      this.#parent[root] = at(this.#parent, next);
      root = next;
    }
    return root;
  }

  /** Edges by their ends, lower first, with their triangles. */
  edges(): ReadonlyMap<string, readonly number[]> {
    const found = new Map<string, number[]>();
    this.triangles.forEach(({corners: [a, b, c]}, triangle) => {
      for (const [u, v] of [
        [a, b],
        [b, c],
        [c, a],
      ] as const) {
        const key = `${Math.min(u, v)},${Math.max(u, v)}`;
        const known = found.get(key);
        if (known) known.push(triangle);
        else found.set(key, [triangle]);
      }
    });
    return found;
  }

  /** Number of pairs of an edge and a triangle that it crosses, without a common vertex. */
  crossings(): number {
    const edges = [...this.edges().keys()].map(
      (key) => key.split(',').map(Number) as [number, number],
    );
    const lengths = edges.map(([u, v]) => distance3(at(this.places, u), at(this.places, v)));
    const size =
      2 *
      at(
        lengths.toSorted((a, b) => a - b),
        Math.floor(lengths.length / 2),
      );
    const cells = new Cells(
      this.triangles.map(({worn}) => worn),
      size,
    );
    let count = 0;
    for (const [u, v] of edges) {
      const [p, q] = [at(this.places, u), at(this.places, v)];
      for (const k of cells.near([p, q])) {
        const {corners, worn} = at(this.triangles, k);
        if (corners.includes(u) || corners.includes(v)) continue;
        if (passes(p, q, worn)) count++;
      }
    }
    return count;
  }

  /** The lines without a seam, each as the numbers of its vertices. */
  rims(): readonly (readonly number[])[] {
    const next = new Map<number, number[]>();
    const link = (u: number, v: number) => next.set(u, [...(next.get(u) ?? []), v]);
    for (const [key, triangles] of this.edges()) {
      if (triangles.length !== 1) continue;
      const [u = 0, v = 0] = key.split(',').map(Number);
      link(u, v);
      link(v, u);
    }
    const rims: number[][] = [];
    const seen = new Set<number>();
    for (const start of next.keys()) {
      if (seen.has(start)) continue;
      const rim = [start];
      seen.add(start);
      for (const vertex of rim) {
        for (const other of next.get(vertex) ?? []) {
          if (seen.has(other)) continue;
          seen.add(other);
          rim.push(other);
        }
      }
      rims.push(rim);
    }
    return rims;
  }
}

/**
 * Volume that counts as mere contact in files: ends of straps that meet in a body's plane. [cm^3]
 */
const touching = 1e-9;

/** Returns whether a segment passes through the inside of a triangle. */
function passes(p: Place, q: Place, [a, b, c]: readonly [Place, Place, Place]): boolean {
  const volume = (u: Place, v: Place, w: Place, x: Place): number =>
    dot3(minus3(v, u), cross3(minus3(w, u), minus3(x, u)));
  const [from, to] = [volume(p, a, b, c), volume(q, a, b, c)];
  if (Math.min(Math.abs(from), Math.abs(to)) < touching || from > 0 === to > 0) return false;
  const sides = [volume(p, q, a, b), volume(p, q, b, c), volume(p, q, c, a)];
  return sides.every((side) => side > touching) || sides.every((side) => side < -touching);
}
