/**
 * Finds the panels of a garment mesh, which are connected in the texture, and their boundary edges.
 */
import {hashOf, tableSize} from './arrays.js';

/** Triangles by their corners. Side h of a triangle runs from corner h to its next corner. */
interface Sides {
  /** The vertex and the texture coordinate of every corner, both welded. */
  readonly vertices: Int32Array;
  readonly flat: Int32Array;
}

export interface Panels {
  /** For every side, the opposite side at the same edge of its panel; -1 at the boundary. */
  readonly mates: Int32Array;
  /** For every boundary side, the side it is sewn to; -1 if it is free. */
  readonly sewnTo: Int32Array;
  /** For every triangle, a triangle that identifies its panel. */
  readonly panelOf: Int32Array;
  /** Number of edges in a panel with more than two triangles, or two of opposite orientation. */
  readonly broken: number;
  /** Number of edges where more than two panels meet; these stay unsewn. */
  readonly crowded: number;
}

export const nextSide = (side: number): number => (side % 3 === 2 ? side - 2 : side + 1);

export function panelsOf(sides: Sides): Panels {
  const edges = new Edges(sides);
  const {mates, broken} = edges.paired();
  const sewn = edges.sewn(mates);
  return {mates, broken, ...sewn, panelOf: joinedTriangles(mates)};
}

/** Sides by edge of the mesh. Loops allocate nothing, since there are millions of sides. */
class Edges {
  readonly #sides: Sides;
  /** For every side, the previous one at the same edge; -1 for the first. */
  readonly #before: Int32Array;
  /** Hash table of the last side of every edge; -1 in empty slots. */
  readonly #last: Int32Array;

  constructor(sides: Sides) {
    this.#sides = sides;
    const count = sides.vertices.length;
    const mask = tableSize(count) - 1;
    const table = new Int32Array(mask + 1).fill(-1);
    this.#before = new Int32Array(count).fill(-1);
    for (let side = 0; side < count; side++) {
      const [low, high] = [this.#low(side), this.#high(side)];
      let slot = hashOf(low, high) & mask;
      for (let other = table[slot] ?? -1; other >= 0; other = table[slot] ?? -1) {
        if (this.#low(other) === low && this.#high(other) === high) break;
        slot = (slot + 1) & mask;
      }
      this.#before[side] = table[slot] ?? -1;
      table[slot] = side;
    }
    this.#last = table;
  }

  #low(side: number): number {
    const {vertices} = this.#sides;
    return Math.min(vertices[side] ?? 0, vertices[nextSide(side)] ?? 0);
  }

  #high(side: number): number {
    const {vertices} = this.#sides;
    return Math.max(vertices[side] ?? 0, vertices[nextSide(side)] ?? 0);
  }

  paired(): {readonly mates: Int32Array; readonly broken: number} {
    const {flat} = this.#sides;
    const mates = new Int32Array(flat.length).fill(-1);
    let broken = 0;
    for (let side = 0; side < flat.length; side++) {
      const [from, to] = [flat[side], flat[nextSide(side)]];
      for (let other = this.#before[side] ?? -1; other >= 0; other = this.#before[other] ?? -1) {
        const [start, end] = [flat[other], flat[nextSide(other)]];
        const isTurned = start === to && end === from;
        if (!isTurned && !(start === from && end === to)) continue;
        if (!isTurned || mates[side] !== -1 || mates[other] !== -1) broken++;
        else [mates[side], mates[other]] = [other, side];
      }
    }
    return {mates, broken};
  }

  sewn(mates: Int32Array): Pick<Panels, 'sewnTo' | 'crowded'> {
    const sewnTo = new Int32Array(mates.length).fill(-1);
    let crowded = 0;
    for (const last of this.#last) {
      let [a, b, count] = [-1, -1, 0];
      for (let side = last; side >= 0; side = this.#before[side] ?? -1) {
        if (mates[side] !== -1) continue;
        [a, b] = [side, a];
        count++;
      }
      if (count > 2) crowded++;
      if (count === 2) [sewnTo[a], sewnTo[b]] = [b, a];
    }
    return {sewnTo, crowded};
  }
}

function joinedTriangles(mates: Int32Array): Int32Array {
  const parents = new Int32Array(mates.length / 3).map((_, triangle) => triangle);
  const rootOf = (triangle: number): number => {
    let root = triangle;
    for (let up = parents[root] ?? root; up !== root; up = parents[root] ?? root) {
      root = parents[root] = parents[up] ?? up;
    }
    return root;
  };
  mates.forEach((mate, side) => {
    if (mate < 0) return;
    const [a, b] = [rootOf(Math.floor(side / 3)), rootOf(Math.floor(mate / 3))];
    parents[Math.max(a, b)] = Math.min(a, b);
  });
  return parents.map((_, triangle) => rootOf(triangle));
}

/** The boundaries of all panels, each as consecutive sides. */
export function rimsOf({mates}: Panels): number[][] {
  const rims: number[][] = [];
  const seen = new Uint8Array(mates.length);
  for (let first = 0; first < mates.length; first++) {
    if (mates[first] !== -1 || seen[first] === 1) continue;
    const rim: number[] = [];
    for (let side = first; seen[side] === 0; side = following(side, mates)) {
      seen[side] = 1;
      rim.push(side);
    }
    rims.push(rim);
  }
  return rims;
}

/** The next side of a boundary, found by walking through the triangles around the corner. */
function following(side: number, mates: Int32Array): number {
  let next = nextSide(side);
  for (let mate = mates[next] ?? -1; mate >= 0; mate = mates[next] ?? -1) next = nextSide(mate);
  return next;
}
