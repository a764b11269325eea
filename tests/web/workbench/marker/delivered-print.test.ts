import {expect, it} from 'vitest';

import {printOf, type DesignPrint} from '@/model/design/design.js';
import {asCut} from '@/model/print/as-cut.js';
import {onDelivered, statedRepeat} from '@/workbench/marker/delivered-print.js';

const near = (value: number): number => expect.closeTo(value, 8) as number;

const print: DesignPrint = {
  title: 'Checks',
  group: 'p4m',
  size: {width: 10, height: 10, angleDeg: 90},
  turnDeg: 0,
  oneWay: false,
  cell: 'primitive',
  image: 'prints/p4m.svg',
};
const shrinkage = {warp: 5, weft: 0};

it('is the print after the wash, and the stated one again once its fabric is as stated', () => {
  const washed = onDelivered(print, {shrinkage, measured: {across: 10.3}});
  expect(washed).toMatchObject({
    group: 'pmm',
    size: {width: near(10.3), height: near(9.5)},
    delivered: {shrinkage, measured: {across: 10.3}},
  });
  expect(statedRepeat(washed)).toEqual({width: 10, height: 10});
  expect(asCut(printOf(washed)).w2[1]).toBeCloseTo(10, 8);
  const other = onDelivered(washed, {shrinkage: {warp: 3, weft: 3}});
  expect(other).toMatchObject({group: 'p4m', size: {width: near(9.7)}});
  expect(onDelivered(other, {})).toEqual({...print, delivered: undefined});
});

it('keeps a size that was chosen after the fabric was entered', () => {
  const washed = onDelivered(print, {shrinkage});
  const {width, height} = washed.size;
  const larger = {...washed, size: {...washed.size, width: 1.1 * width, height: 1.1 * height}};
  const {size} = onDelivered(larger, {shrinkage: {warp: 10, weft: 0}});
  expect([size.width, size.height]).toEqual([near(11), near(9.9)]);
});
