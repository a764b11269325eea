/** Shifts of a print that keep it, and its repeats along and across the fabric. */
import {apply} from '@/model/geometry/plane-map.js';
import {groupNames} from '@/model/base/core-tables.js';
import {describe, expect, it} from 'vitest';

import {acrossRepeat, equalShifts, hasHalfTurn, warpRepeat} from '@/marker/repeats.js';
import {distance, minus, norm, plus, type Point} from '@/model/geometry/vectors.js';
import {type GroupName} from '@/model/print/repeating-print.js';
import {latticeType, printElements, reduced, type Repeat} from '@/model/print/wallpaper.js';

const lattices: Readonly<Record<ReturnType<typeof latticeType>, readonly [Point, Point]>> = {
  oblique: [
    [10, 0],
    [3, 8],
  ],
  rectangular: [
    [0, 14],
    [-10, 0],
  ],
  rhombic: [
    [6, 4],
    [-6, 4],
  ],
  square: [
    [9, 0],
    [0, 9],
  ],
  hexagonal: [
    [10, 0],
    [5, 5 * Math.sqrt(3)],
  ],
};

const repeatOf = (group: GroupName): Repeat => {
  const [w1, w2] = lattices[latticeType(group)];
  return {group, w1, w2};
};

describe('shifts after which a print fits as well', () => {
  it.each(groupNames)('of %s keep its group', (group) => {
    const repeat = repeatOf(group);
    for (const v of equalShifts(repeat)) {
      expect(norm(reduced(repeat, v))).toBeGreaterThan(0.1); // a zero shift is excluded
      for (const element of printElements(repeat)) {
        const [there, here] = [apply(element, plus([1, 2], v)), plus(apply(element, [1, 2]), v)];
        expect(norm(reduced(repeat, minus(there, here)))).toBeLessThan(1e-6);
      }
    }
  });

  it.each<[GroupName, number]>([
    ['p2', 3],
    ['pmm', 3],
    ['pmg', 3],
    ['pgg', 3],
    ['cmm', 1],
    ['p3', 2],
    ['p3m1', 2],
    ['p31m', 0],
    ['p4', 1],
    ['p4m', 1],
    ['p4g', 1],
    ['p6', 0],
    ['p6m', 0],
  ])('are, of %s, %i beside none', (group, count) => {
    expect(equalShifts(repeatOf(group))).toHaveLength(count);
  });

  it.each<GroupName>(['p1', 'pm', 'pg', 'cm'])('of %s run on in fine steps', (group) => {
    const shifts = equalShifts(repeatOf(group));
    expect(shifts.length).toBeGreaterThan(10);
    expect(shifts.length).toBeLessThanOrEqual(400);
    const [first = [0, 0]] = shifts;
    const others = [[0, 0] as Point, ...shifts].filter((v) => v !== first);
    expect(Math.min(...others.map((v) => distance(first, v)))).toBeLessThanOrEqual(1);
  });
});

describe('a print repeats', () => {
  const repeat = (w1: Point, w2: Point): Repeat => ({group: 'p1', w1, w2});

  it('across the fabric by its lattice, and by less where the fabric may be cut anywhere', () => {
    expect(acrossRepeat(repeat([10, 0], [0, 14]))).toBeCloseTo(10, 9);
    expect(acrossRepeat(repeat([6, 4], [-6, 4]))).toBeCloseTo(6, 9);
    expect(acrossRepeat(repeat([6, 4], [-6, 4]), true)).toBeCloseTo(12, 9);
    expect(acrossRepeat(repeat([10, 0], [4, 9]))).toBeCloseTo(2, 9);
    const [turned, other]: Point[] = [
      [8 * Math.cos(0.3), 8 * Math.sin(0.3)],
      [-9 * Math.sin(0.3), 9 * Math.cos(0.3)],
    ];
    expect(acrossRepeat(repeat(turned ?? [1, 0], other ?? [0, 1]))).toBeCloseTo(8, 9);
  });

  it('along it, or never', () => {
    expect(warpRepeat(repeat([10, 0], [5, 5 * Math.sqrt(3)]))).toBeCloseTo(10 * Math.sqrt(3), 9);
    expect(warpRepeat(repeat([8, 1], [-Math.SQRT2, 9]))).toBeUndefined();
  });

  it('upside down by its group', () => {
    expect(groupNames.filter((group) => !hasHalfTurn(repeatOf(group)))).toEqual(
      groupNames.filter((group) => /^(p1|pm|pg|cm|p3.*)$/.test(group)),
    );
  });
});
