/**
 * Describes a print by the cell that the user holds, since several cells of a group describe the
 * same print.
 */
import {combined, minus, norm, type Point} from '../model/geometry/vectors.js';
import {latticeOf, pixelOf, rebased, vectorsAtMiddle} from '../model/print/photo-map.js';
import type {PhotoMap, PhotoReading} from '../model/print/photo-reading.js';
import type {GroupName} from '../model/print/repeating-print.js';

/** New vectors in terms of the old ones. */
type Basis = readonly [Point, Point];

const asItIs: Basis = [
  [1, 0],
  [0, 1],
];
const quarter: Basis = [
  [0, 1],
  [-1, 0],
];
const sixth: Basis = [
  [0, 1],
  [-1, 1],
];

/**
 * Returns the turns that map a cell of the group to a cell of the group. w1 and w2 of hexagonal
 * groups are 60 degrees apart.
 */
function turnsOf(group: GroupName): readonly Basis[] {
  const byQuarters = ['p4', 'p4m', 'p4g', 'pmm', 'pgg', 'cmm'].includes(group);
  const bySixths = ['p3', 'p3m1', 'p31m', 'p6', 'p6m'].includes(group);
  const [turn, count] = byQuarters ? [quarter, 4] : bySixths ? [sixth, 6] : [asItIs, 1];
  const turns = [asItIs];
  for (let k = 1; k < count; k++) {
    const [w1, w2] = turns[k - 1] ?? asItIs;
    turns.push([combined([w1, w2], ...turn[0]), combined([w1, w2], ...turn[1])]);
  }
  const halves = turns.map(([w1, w2]): Basis => [minus([0, 0], w1), minus([0, 0], w2)]);
  return count === 1 ? [...turns, ...halves] : turns;
}

const [half, third] = [1 / 2, 1 / 3];
const corner: Point = [0, 0];
const middle: Point = [half, half];

/**
 * Returns the places of a cell that are equivalent to its corner as origin: translations of the
 * group's normaliser.
 */
function originsOf(group: GroupName): readonly Point[] {
  if (['p2', 'pm', 'pg', 'pmg', 'pmm', 'pgg'].includes(group))
    return [corner, [half, 0], [0, half], middle];
  if (['cmm', 'p4', 'p4m', 'p4g'].includes(group)) return [corner, middle];
  if (['p3', 'p3m1'].includes(group)) return [corner, [third, third], [2 * third, 2 * third]];
  return [corner];
}

const fraction = ([u, v]: Point): Point => [u - Math.round(u), v - Math.round(v)];

/**
 * Returns the cell of `map` nearest to a cell of `held`: its basis, and its origin in lattice
 * coordinates of `map`.
 */
function nearestCell(
  map: PhotoMap,
  held: PhotoMap,
  group: GroupName,
  size: PhotoReading,
): {readonly basis: Basis; readonly origin: Point} {
  const at = latticeOf(held, size, [size.width / 2, size.height / 2]);
  const [i, j] = [Math.round(at[0]), Math.round(at[1])];
  const node = (di: number, dj: number): Point =>
    latticeOf(map, size, pixelOf(held, size, [i + di, j + dj]));
  const base = node(0, 0);
  const [w1, w2] = [minus(node(1, 0), base), minus(node(0, 1), base)];
  const off = ([a, b]: Basis): number => norm(minus(a, w1)) + norm(minus(b, w2));
  const basis = turnsOf(group).reduce((best, turn) => (off(turn) < off(best) ? turn : best));
  const away = (origin: Point): number => norm(fraction(minus(base, origin)));
  const origin = originsOf(group).reduce((best, other) =>
    away(other) < away(best) - 1e-6 ? other : best,
  );
  // p1 allows any origin
  return {basis, origin: group === 'p1' ? fraction(base) : origin};
}

/**
 * Returns the reading with those cells of its group that are nearest to the cells of a moved map,
 * so that handles stay where the user holds them. The same applies to another group that was
 * chosen.
 */
export function steadied(
  reading: PhotoReading,
  held: PhotoMap,
  chosen: GroupName | undefined,
): PhotoReading {
  const own = nearestCell(reading.map, held, reading.group, reading);
  const map = rebased(reading.map, own.basis, own.origin);
  const turned = (vectors: readonly [Point, Point]): readonly [Point, Point] => [
    combined(vectors, ...own.basis[0]),
    combined(vectors, ...own.basis[1]),
  ];
  const [w1, w2] = reading.w1 && reading.w2 ? turned([reading.w1, reading.w2]) : [null, null];
  return {
    ...reading,
    ...{map, w1, w2, shape: turned(reading.shape), ...vectorsAtMiddle(map, reading)},
    groups: reading.groups.map((group) => {
      if (group.name === reading.group) return {...group, map};
      if (group.name !== chosen) return group;
      const {basis, origin} = nearestCell(group.map, held, group.name, reading);
      return {...group, map: rebased(group.map, basis, origin)};
    }),
  };
}
