/** Checks whether a claimed group, on its basis and origin, is among the symmetries of a print. */
import type {Point} from '@/model/geometry/vectors.js';
import type {GroupName} from '@/model/print/repeating-print.js';

import {elementsOf} from './group-elements.js';

export type Basis = readonly [Point, Point];

interface ClaimedGroup {
  readonly group: GroupName;
  /**
   * The claimed w1, w2 as columns in the print's lattice coordinates, row by row, determinant 1.
   */
  readonly basis: readonly [number, number, number, number];
  /** The claimed origin in the print's lattice coordinates. */
  readonly origin: Point;
}

interface Agreement {
  /** Every claimed symmetry is one of the print, about some origin. */
  readonly holds: boolean;
  /** Distance from the nearest such origin, in square roots of the cell's area. */
  readonly originError: number;
}

type Matrix = readonly [number, number, number, number];

const times = ([a, b, c, d]: Matrix, [p, q, r, s]: Matrix): Matrix => [
  a * p + b * r,
  a * q + b * s,
  c * p + d * r,
  c * q + d * s,
];
const on = ([a, b, c, d]: Matrix, [x, y]: Point): Point => [a * x + b * y, c * x + d * y];
const wrapped = (x: number): number => x - Math.round(x);

/** Linear part m of a claimed element, and the error of its shift about the print's origin. */
interface Pairing {
  readonly m: Matrix;
  readonly off: Point;
}

/** Pairs the elements; undefined if a linear part is claimed that the print lacks. */
function paired(truth: GroupName, {group, basis}: ClaimedGroup): readonly Pairing[] | undefined {
  const [a, b, c, d] = basis;
  const back: Matrix = [d, -b, -c, a];
  const own = new Map(elementsOf(truth).map((element) => [element.m.join(), element.a]));
  const pairs: Pairing[] = [];
  for (const element of elementsOf(group)) {
    // turns -0 into 0, as their texts must be equal
    const m = times(times(basis, element.m), back).map((x) => x + 0) as unknown as Matrix;
    const shift = own.get(m.join());
    if (!shift) return undefined;
    const claimed = on(basis, element.a);
    pairs.push({m, off: [claimed[0] - shift[0], claimed[1] - shift[1]]});
  }
  return pairs;
}

/**
 * Remaining error of each element's shift for the claimed origin `o`: off + (1 - m) o, modulo 1.
 */
const left = (pairs: readonly Pairing[], o: Point): readonly Point[] =>
  pairs.map(({m, off}) => {
    const image = on(m, o);
    return [wrapped(off[0] + o[0] - image[0]), wrapped(off[1] + o[1] - image[1])];
  });

/** Origins of groups that share a lattice differ by eighths and sixths at the finest. */
const finest = 24;

export function agreement(
  {group, w1, w2}: {readonly group: GroupName; readonly w1: Point; readonly w2: Point},
  claimed: ClaimedGroup,
): Agreement {
  const pairs = paired(group, claimed);
  if (!pairs) return {holds: false, originError: Infinity};
  const area = w1[0] * w2[1] - w1[1] * w2[0];
  const size = (o: Point): number =>
    Math.hypot(o[0] * w1[0] + o[1] * w2[0], o[0] * w1[1] + o[1] * w2[1]) / Math.sqrt(area);
  let least = Infinity;
  for (let j = 0; j < finest; j++) {
    for (let i = 0; i < finest; i++) {
      const o: Point = [i / finest, j / finest];
      if (left(pairs, o).some((r) => Math.hypot(...r) > 1e-6)) continue;
      // the way from there to the claimed origin, except along directions that the group leaves
      // free
      const move: Point = [wrapped(claimed.origin[0] - o[0]), wrapped(claimed.origin[1] - o[1])];
      least = Math.min(least, size(bound(pairs, move)));
    }
  }
  return {holds: least < Infinity, originError: least};
}

/** The shortest move of the origin that changes every element's shift as `move` does. */
function bound(pairs: readonly Pairing[], move: Point): Point {
  let [xx, xy, yy, bx, by] = [1e-9, 0, 1e-9, 0, 0];
  for (const {m} of pairs) {
    const d: Matrix = [1 - m[0], -m[1], -m[2], 1 - m[3]];
    const r = on(d, move);
    xx += d[0] * d[0] + d[2] * d[2];
    xy += d[0] * d[1] + d[2] * d[3];
    yy += d[1] * d[1] + d[3] * d[3];
    bx += d[0] * r[0] + d[2] * r[1];
    by += d[1] * r[0] + d[3] * r[1];
  }
  const det = xx * yy - xy * xy;
  return [(yy * bx - xy * by) / det, (xx * by - xy * bx) / det];
}
