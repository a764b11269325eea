import {apply, determinant} from '@/model/geometry/plane-map.js';
import {groupNames} from '@/model/base/core-tables.js';
import fc from 'fast-check';
import {describe, expect, it} from 'vitest';

import type {Point} from '@/model/geometry/vectors.js';
import {type GroupName} from '@/model/print/repeating-print.js';
import {latticeVectors} from '@/model/print/repeat.js';
import {
  joining,
  imageCell,
  latticeType,
  printDistance,
  printElements,
  reducedBasis,
  type Repeat,
} from '@/model/print/wallpaper.js';

const root3 = Math.sqrt(3);
const lattices: Record<ReturnType<typeof latticeType>, [Point, Point]> = {
  oblique: [
    [7, 1],
    [3, 8],
  ],
  rectangular: [
    [0, 9],
    [-6, 0],
  ],
  rhombic: [
    [4, -3.5],
    [4, 3.5],
  ],
  square: [
    [8, 0],
    [0, 8],
  ],
  hexagonal: [
    [8, 0],
    [4, 4 * root3],
  ],
};
const repeatOf = (group: GroupName): Repeat => {
  const [w1, w2] = lattices[latticeType(group)];
  return {group, w1, w2};
};
const point = fc.tuple(
  fc.double({min: -30, max: 30, noNaN: true}),
  fc.double({min: -30, max: 30, noNaN: true}),
);

/** Numbers of symmetries modulo translations, and of mirrors and glides among them. */
const orders: Record<GroupName, [number, number]> = {
  p1: [1, 0],
  p2: [2, 0],
  pm: [2, 1],
  pg: [2, 1],
  cm: [2, 1],
  pmm: [4, 2],
  pmg: [4, 2],
  pgg: [4, 2],
  cmm: [4, 2],
  p4: [4, 0],
  p4m: [8, 4],
  p4g: [8, 4],
  p3: [3, 0],
  p3m1: [6, 3],
  p31m: [6, 3],
  p6: [6, 0],
  p6m: [12, 6],
};

describe.each([...groupNames])('%s', (group) => {
  const repeat = repeatOf(group);
  const apart = printDistance(repeat);
  const elements = printElements(repeat);

  it('has its number of symmetries, and all of them keep lengths', () => {
    const mirrors = elements.filter((element) => determinant(element) < 0);
    expect([elements.length, mirrors.length]).toEqual(orders[group]);
    for (const {xx, xy, yx, yy} of elements) {
      expect(Math.hypot(xx, yx)).toBeCloseTo(1, 12);
      expect(Math.hypot(xy, yy)).toBeCloseTo(1, 12);
      expect(xx * xy + yx * yy).toBeCloseTo(0, 12);
    }
  });

  it('puts a point and its images at no distance', () => {
    fc.assert(
      fc.property(
        point,
        fc.integer({min: -3, max: 3}),
        fc.integer({min: -3, max: 3}),
        (p, i, j) => {
          for (const element of elements) {
            const [x, y] = apply(element, p);
            const {w1, w2} = repeat;
            expect(apart(p, [x + i * w1[0] + j * w2[0], y + i * w1[1] + j * w2[1]])).toBeLessThan(
              1e-9,
            );
          }
        },
      ),
      {seed: 3, numRuns: 20},
    );
  });

  it('measures the same from both sides, and never more than the plane does', () => {
    fc.assert(
      fc.property(point, point, (p, q) => {
        const d = apart(p, q);
        expect(apart(q, p)).toBeCloseTo(d, 9);
        expect(d).toBeLessThanOrEqual(Math.hypot(p[0] - q[0], p[1] - q[1]) + 1e-12);
      }),
      {seed: 4, numRuns: 40},
    );
  });
});

it('leaves only turns and shifts to join seams by where nothing may be mirrored', () => {
  for (const group of groupNames) {
    const repeat = repeatOf(group);
    expect(joining(repeat)).toBe(repeat);
    const left = printElements(joining(repeat, true));
    const turns = printElements(repeat).filter((element) => determinant(element) > 0);
    expect(left).toHaveLength(turns.length);
    const apart = printDistance(joining(repeat, true));
    for (const turn of turns) expect(apart([1, 2], apply(turn, [1, 2]))).toBeLessThan(1e-9);
  }
});

it('tells mirrors from glides: where the image of (1, 2) lies', () => {
  const repeat = {w1: [10, 0], w2: [0, 8]} as const;
  expect(printDistance({...repeat, group: 'pm'})([1, 2], [1, -2])).toBeCloseTo(0, 12);
  expect(printDistance({...repeat, group: 'pg'})([1, 2], [6, -2])).toBeCloseTo(0, 12);
  expect(printDistance({...repeat, group: 'pg'})([1, 2], [1, -2])).toBeCloseTo(4, 12);
  expect(printDistance({...repeat, group: 'pmg'})([1, 2], [1, 2 - 8])).toBeCloseTo(0, 12);
  expect(printDistance({...repeat, group: 'pmg'})([1, 1], [1, 3])).toBeCloseTo(0, 12);
});

it('reduces hexagonal lattices at any turn, whose shortest vectors are equally long', () => {
  for (let turn = -180; turn <= 180; turn += 0.25) {
    const [w1, w2] = latticeVectors('p6m', {width: 2.9, height: 5, angleDeg: 90}, turn);
    const [a, b] = reducedBasis(w1, w2);
    expect(Math.hypot(...a)).toBeCloseTo(2.9, 9);
    expect(Math.hypot(...b)).toBeCloseTo(2.9, 9);
  }
});

it('finds the rectangular cell of a centred and of a hexagonal lattice', () => {
  const rhombic = {...repeatOf('cm'), cell: 'rectangular'} as const;
  expect(imageCell(rhombic)).toEqual([
    [8, 0],
    [0, 7],
  ]);
  const hexagonal = {...repeatOf('p6m'), cell: 'rectangular'} as const;
  const [a, b] = imageCell(hexagonal);
  expect(a).toEqual([8, 0]);
  expect(b[0]).toBeCloseTo(0, 12);
  expect(b[1]).toBeCloseTo(8 * root3, 12);
});
