import {expect, it} from 'vitest';

import {commonSize} from '@/solver/search/common-size.js';

/** Matched seams, of three, of two garments by size. */
const matches: Readonly<Record<number, readonly [number, number]>> = {
  1: [1, 1],
  0.9: [3, 0],
  1.05: [2, 2],
  1.1: [0, 3],
};

const standingOf = (garment: number, scale: number) => {
  const matched = matches[scale]?.[garment];
  return matched === undefined
    ? Promise.reject(new Error('no size'))
    : Promise.resolve({visible: 3, matched, answerCost: 3 - matched});
};

it('is best for all garments together, not for one of them', async () => {
  const seen: string[] = [];
  const scale = await commonSize(2, {
    scales: [1, 0.9, 0.8, 1.05, 1.1],
    standingOf,
    onCompared: ({scale: one, matched, isBest}) => {
      seen.push(`${one}: ${matched}${isBest ? ' best' : ''}`);
    },
    onRefused: (one) => {
      seen.push(`${one}: none`);
    },
  });
  expect(scale).toBe(1.05);
  expect(seen).toEqual(['1: 2 best', '0.9: 3 best', '0.8: none', '1.05: 4 best', '1.1: 3']);
});

it('fails if the first size does', async () => {
  await expect(commonSize(2, {scales: [0.8, 1], standingOf})).rejects.toThrow('no size');
});
