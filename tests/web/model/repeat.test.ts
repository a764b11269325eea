import {apply} from '@/model/geometry/plane-map.js';
import {groupNames} from '@/model/base/core-tables.js';
import {readdirSync, readFileSync} from 'node:fs';
import {describe, expect, it} from 'vitest';

import type {Point} from '@/model/geometry/vectors.js';
import {type GroupName, type Print} from '@/model/print/repeating-print.js';
import {
  carries,
  coupledSize,
  fittingGroup,
  groupsThatCarry,
  isCoupled,
  latticeVectors,
  repeatOf,
  type RepeatSize,
} from '@/model/print/repeat.js';
import {printDistance, printElements, type Repeat} from '@/model/print/wallpaper.js';

const measured: RepeatSize = {width: 7, height: 9.5, angleDeg: 70};

describe.each([...groupNames])('the repeat of %s', (group) => {
  it.each([0, 30, 90, 135, 180, -90, -179])('is measured as it was made, turned by %d', (turn) => {
    const [w1, w2] = latticeVectors(group, measured, turn);
    const {size, turnDeg} = repeatOf({group, w1, w2});
    const demanded = coupledSize(group, measured);
    expect(size.width).toBeCloseTo(demanded.width, 9);
    expect(size.height).toBeCloseTo(demanded.height, 9);
    expect(size.angleDeg).toBeCloseTo(demanded.angleDeg, 9);
    expect(turnDeg).toBeCloseTo(turn, 9);
  });
});

const folder = new URL('../../../public/prints/', import.meta.url);
const samples = readdirSync(folder)
  .filter((file) => file.endsWith('.json'))
  .map((file): [string, Print] => [
    file,
    JSON.parse(readFileSync(new URL(file, folder), 'utf8')) as Print,
  ]);

it.each(samples)('makes the lattice of %s again from its measures', (_, {group, w1, w2}) => {
  const {size, turnDeg} = repeatOf({group, w1, w2});
  const again = latticeVectors(group, size, turnDeg).flat();
  [...w1, ...w2].forEach((value, k) => {
    expect(again[k]).toBeCloseTo(value, 9);
  });
});

it('measures a half-drop whose mirrors stand upright by its rectangle, a quarter turned', () => {
  const {size, turnDeg} = repeatOf({group: 'cm', w1: [4.5, 6], w2: [-4.5, 6]});
  expect(size.width).toBeCloseTo(12, 12);
  expect(size.height).toBeCloseTo(9, 12);
  expect(turnDeg).toBeCloseTo(90, 12);
});

it('lets the height follow the width on squares and on triangles', () => {
  expect(groupNames.filter(isCoupled)).toEqual('p4 p4m p4g p3 p3m1 p31m p6 p6m'.split(' '));
  expect(coupledSize('p4g', {width: 8, height: 3, angleDeg: 80})).toEqual({
    ...{width: 8, height: 8, angleDeg: 90},
  });
  expect(coupledSize('p6', {width: 10, height: 3, angleDeg: 80}).height).toBeCloseTo(17.3205, 4);
});

/** The largest fitting group on a cell that is slightly too high, and on a slanted one. */
const smaller: Partial<
  Record<GroupName, readonly [higher: GroupName | undefined, slanted: GroupName]>
> = {
  pm: [undefined, 'p1'],
  pg: [undefined, 'p1'],
  cm: [undefined, 'p1'],
  pmm: [undefined, 'p2'],
  pmg: [undefined, 'p2'],
  pgg: [undefined, 'p2'],
  cmm: [undefined, 'p2'],
  p4: ['p2', 'p2'],
  p4m: ['pmm', 'p2'],
  p4g: ['pgg', 'p2'],
  p3: ['p1', 'p1'],
  p3m1: ['cm', 'p1'],
  p31m: ['cm', 'p1'],
  p6: ['p2', 'p2'],
  p6m: ['cmm', 'p2'],
};

const repeat = (group: GroupName, size: RepeatSize, turnDeg: number): Repeat => {
  const [w1, w2] = latticeVectors(group, size, turnDeg);
  return {group, w1, w2};
};

describe.each([...groupNames])('measured cloth of %s', (group) => {
  const ideal = coupledSize(group, {width: 10, height: 8, angleDeg: 90});
  /** Slightly beyond the tolerance for measuring errors. */
  const higher = {...ideal, height: ideal.height * 1.0051};
  const slanted = {...ideal, angleDeg: 90.3};

  it('keeps its group when it is what the group demands, up to half a per cent', () => {
    expect(fittingGroup(group, ideal)).toBeUndefined();
    expect(fittingGroup(group, {...ideal, height: ideal.height * 0.9951})).toBeUndefined();
    expect(fittingGroup(group, {...ideal, angleDeg: 89.8})).toBeUndefined();
  });

  it('falls to the largest group that fits when it is not', () => {
    expect([fittingGroup(group, higher)?.group, fittingGroup(group, slanted)?.group]).toEqual([
      ...(smaller[group] ?? [undefined, undefined]),
    ]);
  });

  it.each([higher, slanted])('loses symmetries, but gains none %#', (size) => {
    const fitting = fittingGroup(group, size);
    if (!fitting) return;
    const large = repeat(group, ideal, 20);
    const small = repeat(fitting.group, fitting.size, 20 + fitting.turnDeg);
    const apart = printDistance(large);
    const points: Point[] = [[0, 0], [1, 0.3], [-0.4, 1.7], small.w1, small.w2];
    for (const element of printElements(small)) {
      for (const p of points) expect(apart(p, apply(element, p))).toBeLessThan(0.1);
    }
    const repeats = printDistance({...large, group: 'p1'});
    expect(repeats([0, 0], small.w1)).toBeLessThan(0.1);
    expect(repeats([0, 0], small.w2)).toBeLessThan(0.1);
  });
});

it('turns the axes of what is left of p3m1, whose mirrors stand across its width', () => {
  expect(fittingGroup('p3m1', {width: 10, height: 18, angleDeg: 90})).toEqual({
    group: 'cm',
    size: {width: 18, height: 10, angleDeg: 90},
    turnDeg: 90,
    cell: 'rectangular',
  });
});

it('calls a measured rectangle of a rectangular group its primitive cell', () => {
  expect(fittingGroup('p4m', {width: 10, height: 10.4, angleDeg: 90})).toEqual({
    group: 'pmm',
    size: {width: 10, height: 10.4, angleDeg: 90},
    turnDeg: 0,
    cell: 'primitive',
  });
});

it('lets mirrors carry a symmetric piece, and glides at least a mirrored pair', () => {
  expect(groupsThatCarry('piece').join()).toBe('pm,cm,pmm,pmg,cmm,p4m,p4g,p3m1,p31m,p6m');
  expect(groupNames.filter((g) => carries(g, 'pair') && !carries(g, 'piece'))).toEqual([
    'pg',
    'pgg',
  ]);
});
