/** Geometry in space for the checks of drapes. */
import type {Place} from '@/model/documents/drape-file.js';

export const plus3 = (a: Place, b: Place, factor = 1): Place => [
  a[0] + factor * b[0],
  a[1] + factor * b[1],
  a[2] + factor * b[2],
];

export const minus3 = (a: Place, b: Place): Place => plus3(a, b, -1);

export const dot3 = (a: Place, b: Place): number => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];

export const cross3 = (a: Place, b: Place): Place => [
  a[1] * b[2] - a[2] * b[1],
  a[2] * b[0] - a[0] * b[2],
  a[0] * b[1] - a[1] * b[0],
];

export const norm3 = (a: Place): number => Math.sqrt(dot3(a, a));

export const distance3 = (a: Place, b: Place): number => norm3(minus3(a, b));

export const middle3 = (...places: readonly Place[]): Place =>
  places.reduce((sum, place) => plus3(sum, place, 1 / places.length), [0, 0, 0]);

/** The point of a segment nearest to `p`. */
function nearestOnSegment(a: Place, b: Place, p: Place): Place {
  const way = minus3(b, a);
  const share = dot3(minus3(p, a), way) / (dot3(way, way) || 1);
  return plus3(a, way, Math.max(0, Math.min(1, share)));
}

/** Distance of `p` from a triangle. */
export function toTriangle([a, b, c]: readonly [Place, Place, Place], p: Place): number {
  const normal = cross3(minus3(b, a), minus3(c, a));
  const isWithin = [
    [a, b],
    [b, c],
    [c, a],
  ].every(([from, to]) => {
    if (!from || !to) return false;
    return dot3(cross3(minus3(to, from), minus3(p, from)), normal) >= 0;
  });
  const area = norm3(normal);
  if (isWithin && area > 0) return Math.abs(dot3(minus3(p, a), normal)) / area;
  const ends = [nearestOnSegment(a, b, p), nearestOnSegment(b, c, p), nearestOnSegment(c, a, p)];
  return Math.min(...ends.map((end) => distance3(end, p)));
}

/** Objects in space by the cells of a grid that their boxes overlap. */
export class Cells {
  readonly #size: number;
  readonly #cells = new Map<number, number[]>();

  /** @param size  of a cell; the boxes are those of each object's points */
  constructor(things: readonly (readonly Place[])[], size: number) {
    this.#size = size;
    things.forEach((points, thing) => {
      for (const key of this.#keys(points, 0)) {
        const known = this.#cells.get(key);
        if (known) known.push(thing);
        else this.#cells.set(key, [thing]);
      }
    });
  }

  /** All objects whose boxes share a cell with that of these points, enlarged by `margin`. */
  near(points: readonly Place[], margin = 0): ReadonlySet<number> {
    return new Set(this.#keys(points, margin).flatMap((key) => this.#cells.get(key) ?? []));
  }

  /** Distant cells may share a key, so that the result may include further objects. */
  #keys(points: readonly Place[], margin: number): number[] {
    const range = (axis: 0 | 1 | 2): number[] => {
      const values = points.map((point) => point[axis]);
      const low = Math.floor((Math.min(...values) - margin) / this.#size);
      const high = Math.floor((Math.max(...values) + margin) / this.#size);
      return Array.from({length: high - low + 1}, (_, k) => low + k);
    };
    const [ys, zs] = [range(1), range(2)];
    return range(0).flatMap((x) => ys.flatMap((y) => zs.map((z) => (x * 65536 + y) * 65536 + z)));
  }
}
