/** How the benchmark sums up what it measured. */
import {expect, it} from 'vitest';

import {exponent, median, quotient, ratiosOf, summary} from '../bench/ratios.mjs';

/** A case of the search: what 1000 random starts and the search found, in so much time. */
const searched = (garment: string, fits: readonly [number, number], times = [100, 10]) => ({
  garment,
  group: 'pmm',
  symmetry: 'auto',
  starts: {best: fits[0], milliseconds: times[0]},
  search: {fitSearch: fits[1], milliseconds: times[1]},
});

const ratio = (results: Record<string, unknown>, title: string, over = 'median') =>
  ratiosOf(results).find((one) => one.title.startsWith(title) && one.over === over);

it('takes the middle value as the median, or the mean of the two middle ones', () => {
  expect(median([9, 1, 2])).toBe(2);
  expect(median([4, 1, 9, 2])).toBe(3);
});

it('divides fits, unless neither leaves any mismatch', () => {
  expect(quotient(2, 4)).toBe(0.5);
  expect(quotient(1e-7, 1e-9)).toBeNull();
  expect(quotient(5, 1e-9)).toBe(Infinity);
});

it('finds by which power figures grow', () => {
  const cubes = [1, 2, 5].map((x): [number, number] => [x, 7 * x ** 3]);
  expect(exponent(cubes)).toBeCloseTo(3, 12);
});

it('says of a ratio which case is worst, and how many miss the goal', () => {
  const numbers = [0.5, 0.95, 0.7].map((value, k) => ({name: `case ${k}`, value}));
  expect(summary('of fits', 'median', 0.85, 0.6, numbers)).toEqual({
    title: 'of fits',
    over: 'median',
    value: 0.7,
    goal: 0.85,
    aim: 0.6,
    met: true,
    reached: false,
    worst: {name: 'case 1', value: 0.95},
    missed: 1,
    cases: 3,
  });
});

it('lets one case miss a goal that all of them have to meet', () => {
  const numbers = [0.5, 1.2].map((value, k) => ({name: `case ${k}`, value}));
  expect(summary('of fits', 'worst', 1, 1, numbers)).toMatchObject({value: 1.2, met: false});
});

it('compares the search with random starts, leaving out what both solve', () => {
  const search = [
    searched('tee', [200, 180]),
    searched('shirt', [100, 101]),
    searched('apron', [1e-8, 1e-9]),
  ];
  const worst = ratio({search}, 'fitSearch / best', 'worst');
  expect(worst).toMatchObject({cases: 2, met: false, worst: {name: 'shirt, pmm, auto'}});
  expect(worst?.value).toBeCloseTo(1.01, 12);
  expect(ratio({search}, 'search time')?.value).toBeCloseTo(0.1, 12);
});

it('tells apart the answers after a change and those after a change of symmetry', () => {
  const changes = {
    weight: {first: 2, final: 20},
    pin: {first: 4, final: 40},
    symmetryAdded: {first: 3, final: 90},
  };
  const edits = [{garment: 'tee', factorisation: {numeric: 2}, edit: {changes}}];
  expect(ratio({edits}, 'first answer')?.value).toBe(1.5);
  expect(ratio({edits}, 'final answer after one change')?.value).toBe(15);
  expect(ratio({edits}, 'final answer after symmetry')?.value).toBe(45);
});

it('says nothing of what was not measured', () => {
  expect(ratiosOf({})).toEqual([]);
});
