/**
 * The 17 wallpaper groups: their symmetries on a given lattice, and the distance between points
 * modulo them.
 */
import {groupTable} from '../base/core-tables.js';
import {
  after,
  apply,
  determinant,
  identity,
  planeMap,
  type PlaneMap,
} from '../geometry/plane-map.js';
import {
  combined,
  coordinates,
  cross,
  dot,
  minus,
  norm,
  plus,
  type Point,
} from '../geometry/vectors.js';
import type {GroupName, Print} from './repeating-print.js';

/**
 * Requirements of a group on w1, w2: none, a right angle, equal lengths, both, or equal lengths at
 * 60 degrees.
 */
export type LatticeType = 'oblique' | 'rectangular' | 'rhombic' | 'square' | 'hexagonal';

/** A symmetry in lattice coordinates (u, v), in the form of the table. */
type Generator = readonly [number, number, number, number, number, number];

/** A print's lattice and group, the only data that the geometry depends on. */
export type Repeat = Pick<Print, 'group' | 'w1' | 'w2'>;

/** A repeat with the kind of cell in the print's image. */
export type CellOf = Repeat & Pick<Print, 'cell'>;

export const latticeType = (group: GroupName): LatticeType => groupTable[group][0];

/**
 * Returns whether the rectangular cell of a group's lattice also has a lattice point in its middle,
 * so that w1 and w2 are not its sides.
 */
export const isCentred = (group: GroupName): boolean =>
  ['rhombic', 'hexagonal'].includes(latticeType(group));

/** One symmetry per linear part, in lattice coordinates; the first is the identity. */
function latticeElements(group: GroupName): readonly PlaneMap[] {
  const [, order, generators] = groupTable[group];
  const maps = (generators as readonly Generator[]).map((numbers) => planeMap(...numbers));
  const elements = [identity];
  const same = (a: PlaneMap, b: PlaneMap): boolean =>
    a.xx === b.xx && a.xy === b.xy && a.yx === b.yx && a.yy === b.yy;
  for (let i = 0; i < elements.length && elements.length < order; i++) {
    for (const generator of maps) {
      const known = elements[i];
      if (!known) continue;
      const next = after(generator, known);
      if (!elements.some((element) => same(element, next))) elements.push(next);
    }
  }
  return elements;
}

/** One symmetry of the print per linear part, in centimetres; the first is the identity. */
export function printElements({group, w1, w2}: Repeat): readonly PlaneMap[] {
  const basis = planeMap(w1[0], w2[0], w1[1], w2[1]);
  const d = determinant(basis);
  const inverse = planeMap(w2[1] / d, -w2[0] / d, -w1[1] / d, w1[0] / d);
  return latticeElements(group).map((element) => after(basis, after(element, inverse)));
}

/**
 * Symmetries under which a print may match across a seam: all, or with `continuousOnly` those that
 * do not mirror it.
 */
export function joining(repeat: Repeat, continuousOnly = false): Repeat {
  if (!continuousOnly) return repeat;
  const turns = latticeElements(repeat.group).filter((element) => determinant(element) > 0).length;
  const left = (['p1', 'p2', 'p3', 'p4', 'p6'] as const).find(
    (group) => groupTable[group][1] === turns,
  );
  return {...repeat, group: left ?? 'p1'};
}

/**
 * Sides of the cell in an image of the print, from its lower left corner: to the right, and up.
 * [cm]
 */
export function imageCell({group, w1, w2, cell}: CellOf): readonly [Point, Point] {
  if (cell === 'rectangular' && latticeType(group) === 'hexagonal') {
    return [w1, combined([w1, w2], -1, 2)];
  }
  const holdsTwo =
    cell === 'centred' || (cell === 'rectangular' && latticeType(group) === 'rhombic');
  if (!holdsTwo) return [w1, w2];
  // w1 - w2 points to the right of w1 + w2 when w1, w2 are right-handed
  return [plus(w1, w2), minus(w2, w1)];
}

/** A basis of the same lattice with the shortest vectors (Lagrange). */
export function reducedBasis(w1: Point, w2: Point): readonly [Point, Point] {
  let a = w1;
  let b = w2;
  for (;;) {
    if (norm(a) > norm(b)) [a, b] = [b, a];
    const shorter = plus(b, a, -Math.round(dot(a, b) / dot(a, a)));
    // rounding alone might never end for vectors of equal length, as on hexagonal lattices
    if (norm(shorter) >= norm(b) * (1 - 1e-9)) return [a, b];
    b = shorter;
  }
}

/** All vectors of a lattice with at most `reach` steps along either vector of its basis. */
export function latticeAround(basis: readonly [Point, Point], reach: number): readonly Point[] {
  const steps = Array.from({length: 2 * reach + 1}, (_, k) => k - reach);
  return steps.flatMap((i) => steps.map((j) => combined(basis, i, j)));
}

/** The shortest vector that differs from `v` by whole repeats. */
export function reduced({w1, w2}: Pick<Repeat, 'w1' | 'w2'>, v: Point): Point {
  const basis = reducedBasis(w1, w2);
  const [s, t] = coordinates(basis, v);
  const short = minus(v, combined(basis, Math.round(s), Math.round(t)));
  // rounding finds a short vector; the shortest is that one or one of its neighbours
  return latticeAround(basis, 1)
    .map((vector) => plus(short, vector))
    .reduce((best, one) => (norm(one) < norm(best) * (1 - 1e-9) ? one : best), short);
}

/** Print mismatch of two points of the print: their distance modulo its symmetries. [cm] */
export function printDistance(repeat: Repeat): (x: Point, y: Point) => number {
  const elements = printElements(repeat);
  const [a, b] = reducedBasis(repeat.w1, repeat.w2);
  const d = cross(a, b);
  return (x, y) => {
    let least = Infinity;
    for (const element of elements) {
      const image = apply(element, y);
      const vx = x[0] - image[0];
      const vy = x[1] - image[1];
      const s = Math.round((vx * b[1] - vy * b[0]) / d);
      const t = Math.round((a[0] * vy - a[1] * vx) / d);
      for (let i = s - 1; i <= s + 1; i++) {
        for (let j = t - 1; j <= t + 1; j++) {
          const dx = vx - i * a[0] - j * b[0];
          const dy = vy - i * a[1] - j * b[1];
          least = Math.min(least, dx * dx + dy * dy);
        }
      }
    }
    return Math.sqrt(least);
  };
}
