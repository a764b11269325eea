/**
 * Meshes as walks: each step adds the triangle at an open edge, and a new vertex is stored by its
 * distance from the corner of a parallelogram. So smooth meshes become small numbers.
 */

/** Third corner of a step's triangle: none at an outline, new, beside the edge, or any vertex. */
export const steps = {none: 0, fresh: 1, after: 2, before: 3, known: 4} as const;

/** A sequence of whole numbers. */
export class NumberList {
  readonly numbers: number[];
  #at = 0;

  constructor(numbers: readonly number[] = []) {
    this.numbers = [...numbers];
  }

  next(): number {
    return this.numbers[this.#at++] ?? 0;
  }
}

/** Numbers of a walk. */
export interface WalkNumbers {
  readonly steps: NumberList;
  /** Vertices of steps of the kind `known`. */
  readonly known: NumberList;
  /** Differences of each coordinate. */
  readonly coordinates: readonly NumberList[];
}

/** Open edges of a walk, counter-clockwise around the triangles so far. */
export class OpenEdges {
  readonly #edges = new Set<number>();
  readonly #after = new Map<number, number>();
  readonly #before = new Map<number, number>();

  has(from: number, to: number): boolean {
    return this.#edges.has(from * 2 ** 24 + to);
  }

  open(from: number, to: number): void {
    this.#edges.add(from * 2 ** 24 + to);
    this.#after.set(from, to);
    this.#before.set(to, from);
  }

  close(from: number, to: number): void {
    this.#edges.delete(from * 2 ** 24 + to);
    if (this.#after.get(from) === to) this.#after.delete(from);
    if (this.#before.get(to) === from) this.#before.delete(to);
  }

  /** The end of an open edge that begins at a vertex. */
  after(vertex: number): number | undefined {
    return this.#after.get(vertex);
  }

  /** The beginning of an open edge that ends at a vertex. */
  before(vertex: number): number | undefined {
    return this.#before.get(vertex);
  }
}

/** An open edge, and the third corner of its triangle. */
export type Gate = readonly [from: number, to: number, corner: number];

/** The edges of a triangle. */
export const edgesOf = (a: number, b: number, c: number): readonly [Gate, Gate, Gate] => [
  [a, b, c],
  [b, c, a],
  [c, a, b],
];

/** Opens the edges of a new triangle, and closes those that it meets. */
export function join(border: OpenEdges, gates: Gate[], triangle: readonly Gate[]): void {
  for (const gate of triangle) {
    const [from, to] = gate;
    if (border.has(to, from)) border.close(to, from);
    else {
      border.open(from, to);
      gates.push(gate);
    }
  }
}

/** Returns a mesh of some triangles; the coordinates of a vertex are whole numbers. */
export function walkedMesh(
  count: number,
  {steps: taken, known, coordinates}: WalkNumbers,
): {readonly triangles: Uint32Array; readonly vertices: readonly (readonly number[])[]} {
  const triangles = new Uint32Array(3 * count);
  const vertices: number[][] = [];
  let done = 0;
  const fresh = (predicted: (k: number) => number): number =>
    vertices.push(coordinates.map((list, k) => predicted(k) + list.next())) - 1;
  const at = (vertex: number, k: number): number => vertices[vertex]?.[k] ?? 0;
  while (done < count) {
    const border = new OpenEdges();
    const gates: Gate[] = [];
    const a = fresh(() => 0);
    const b = fresh((k) => at(a, k));
    const c = fresh((k) => at(b, k));
    triangles.set([a, b, c], 3 * done++);
    join(border, gates, edgesOf(a, b, c));
    for (const [from, to, corner] of gates) {
      if (!border.has(from, to)) continue;
      const third = thirdCorner(taken.next(), from, to);
      if (third === undefined) {
        border.close(from, to);
        continue;
      }
      const apex = third(corner);
      triangles.set([to, from, apex], 3 * done++);
      join(border, gates, edgesOf(to, from, apex));
    }
    function thirdCorner(step: number, from: number, to: number) {
      switch (step) {
        case steps.none:
          return undefined;
        case steps.fresh:
          return (corner: number) => fresh((k) => at(from, k) + at(to, k) - at(corner, k));
        case steps.after:
          return () => border.after(to) ?? 0;
        case steps.before:
          return () => border.before(from) ?? 0;
        default:
          return () => known.next();
      }
    }
  }
  return {triangles, vertices};
}

/** Stores lists of numbers: the length of each, and four planes of bytes, the lowest first. */
export function bytesOfLists(lists: readonly NumberList[]): Uint8Array {
  const size = lists.reduce((sum, {numbers}) => sum + 4 + 4 * numbers.length, 0);
  const bytes = new Uint8Array(size);
  const view = new DataView(bytes.buffer);
  let at = 0;
  for (const {numbers} of lists) {
    view.setUint32(at, numbers.length, true);
    at += 4;
    numbers.forEach((value, k) => {
      const unsigned = value < 0 ? -2 * value - 1 : 2 * value;
      for (let plane = 0; plane < 4; plane++)
        bytes[at + plane * numbers.length + k] = Math.floor(unsigned / 256 ** plane) % 256;
    });
    at += 4 * numbers.length;
  }
  return bytes;
}

/** Reads lists of numbers. */
export function listsIn(bytes: Uint8Array): readonly NumberList[] {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.length);
  const lists: NumberList[] = [];
  for (let at = 0; at < bytes.length;) {
    const count = view.getUint32(at, true);
    const from = at + 4;
    const numbers = Array.from({length: count}, (_, k) => {
      let value = 0;
      for (let plane = 3; plane >= 0; plane--)
        value = value * 256 + (bytes[from + plane * count + k] ?? 0);
      return value % 2 === 0 ? value / 2 : -(value + 1) / 2;
    });
    lists.push(new NumberList(numbers));
    at = from + 4 * count;
  }
  return lists;
}
