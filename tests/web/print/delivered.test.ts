import {expect, it} from 'vitest';

import {readPrint} from '@/print/read-print.js';

const near = (value: number): number => expect.closeTo(value, 8) as number;

const print = {group: 'p4m', w1: [10, 0], w2: [0, 10], title: 'Checks'};
const read = (fabric: object) =>
  readPrint(
    {} as Parameters<typeof readPrint>[0],
    new File([JSON.stringify({...print, fabric})], 'checks.json'),
  );

it('opens a print file on the fabric that it states', async () => {
  const shrinkage = {warp: 5, weft: 2};
  expect(await read({shrinkage})).toMatchObject({
    group: 'pmm',
    size: {width: near(9.8), height: near(9.5)},
    delivered: {shrinkage, stated: {group: 'p4m', size: {width: 10}}},
  });
  const plain = await read({usableWidthCm: 140});
  expect([plain.group, plain.delivered]).toEqual(['p4m', undefined]);
  await expect(read({measured: {across: 30}})).rejects.toThrow('measures 30 cm across');
});
