import {describe, expect, it} from 'vitest';

import {groupNames} from '@/model/base/core-tables.js';
import {after, apply, scaling} from '@/model/geometry/plane-map.js';
import {
  distance,
  minus,
  norm,
  onPrint,
  type Alignment,
  type Point,
} from '@/model/geometry/vectors.js';
import {asCut, cutAlignment, cutMap} from '@/model/print/as-cut.js';
import {asSewn, checkDelivered, withFabric} from '@/model/print/as-sewn.js';
import {latticeVectors} from '@/model/print/repeat.js';
import type {Delivered, GroupName, Print, PrintCell} from '@/model/print/repeating-print.js';
import {imageCell, printElements, reduced} from '@/model/print/wallpaper.js';

const printOf = (group: GroupName, turnDeg: number, cell: PrintCell): Print => {
  const [w1, w2] = latticeVectors(group, {width: 10, height: 14, angleDeg: 75}, turnDeg, cell);
  return {group, w1, w2, cell};
};

const shrinkage = {warp: 6, weft: 2};
const wash: Point = [0.98, 0.94];
const washed = ([x, y]: Point): Point => [x * wash[0], y * wash[1]];

const cases = groupNames.flatMap((group) =>
  ([0, 90, 45, 17] as const).flatMap((turn) =>
    (['primitive', 'rectangular'] as const).map((cell) => [group, turn, cell] as const),
  ),
);

describe('a print on fabric that shrinks unevenly', () => {
  it.each(cases)(
    '%s, turned by %i degrees, %s cell: keeps its picture and only true symmetries',
    (group, turn, cell) => {
      const print = printOf(group, turn, cell);
      const sewn = asSewn(withFabric(print, {shrinkage}));
      expect(sewn.delivered).toEqual({shrinkage});
      const [cells, before] = [imageCell(sewn), imageCell(print)];
      expect(distance(cells[0], washed(before[0]))).toBeLessThan(1e-6);
      expect(distance(cells[1], washed(before[1]))).toBeLessThan(1e-6);
      const shrink = scaling(...wash);
      const regrown = scaling(1 / wash[0], 1 / wash[1]);
      const points: Point[] = [
        [1, 2],
        [3.3, -1.7],
      ];
      const own = printElements(print);
      for (const element of printElements(sewn)) {
        const back = after(regrown, after(element, shrink));
        // one element of the stated print does the same
        const off = own.map((one) =>
          Math.max(
            ...points.map((p) => norm(reduced(print, minus(apply(one, p), apply(back, p))))),
          ),
        );
        expect(Math.min(...off)).toBeLessThan(1e-6);
      }
    },
  );

  it.each<[GroupName, PrintCell, GroupName]>([
    ['p4m', 'primitive', 'pmm'],
    ['p4g', 'primitive', 'pgg'],
    ['p6m', 'rectangular', 'cmm'],
    ['p31m', 'rectangular', 'cm'],
    ['pmg', 'primitive', 'pmg'],
    ['cmm', 'rectangular', 'cmm'],
    ['p3', 'primitive', 'p1'],
  ])('leaves of %s, %s cell, %s', (group, cell, left) => {
    expect(asSewn(withFabric(printOf(group, 0, cell), {shrinkage})).group).toBe(left);
  });

  it('keeps its group if it shrinks evenly, and is changed once', () => {
    const even = withFabric(printOf('p4m', 0, 'primitive'), {shrinkage: {warp: 5, weft: 5}});
    const sewn = asSewn(even);
    expect([sewn.group, sewn.w1[0], asSewn(sewn)]).toEqual(['p4m', expect.closeTo(9.5, 9), sewn]);
  });
});

describe('a measured repeat', () => {
  const print = printOf('pmm', 0, 'primitive');
  it('replaces the stated one, across and up, before the wash', () => {
    const sewn = asSewn(withFabric(print, {measured: {across: 10.4}, shrinkage}));
    expect(sewn.w1[0]).toBeCloseTo(10.4 * wash[0], 8);
    expect(sewn.w2[1]).toBeCloseTo(14 * wash[1], 8);
    const cut = asCut(sewn);
    expect([cut.w1[0], cut.w2[1]]).toEqual([expect.closeTo(10.4, 8), expect.closeTo(14, 8)]);
  });

  it.each<[Delivered, Partial<Print>, RegExp]>([
    [
      {measured: {across: 14, up: 10}},
      {},
      /The repeat measures 14 cm across, but 10 cm are stated/,
    ],
    [{measured: {up: 10}}, {}, /measures 10 cm up, but 14 cm are stated, which contradict/],
    [{measured: {across: 10}}, {unscaled: true}, /A print of unknown size has no stated repeat/],
    [{measured: {across: 10}}, {w1: [8, 1]}, /does not repeat straight across and up/],
    [{shrinkage: {warp: 120, weft: 0}}, {}, /shrinkage along the warp is 120 %, but must be/],
  ])('contradicts: %j', (fabric, changed, sentence) => {
    expect(() => {
      checkDelivered(withFabric({...print, ...changed}, fabric));
    }).toThrow(sentence);
  });
});

it('shows the same print on a piece that is cut larger', () => {
  const alignment: Alignment = {angle: 0.4, translation: [3, -2]};
  const larger = cutMap(alignment, {shrinkage});
  const placed = cutAlignment(alignment, {shrinkage});
  for (const p of [
    [0, 0],
    [12, 5],
    [-3, 40],
  ] as Point[]) {
    const [x, y] = onPrint(alignment, p);
    const shown = onPrint(placed, larger(p));
    expect(distance(washed(shown), [x, y])).toBeLessThan(1e-9);
  }
});
