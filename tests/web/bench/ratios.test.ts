/** The benchmark's summaries of its measurements. */
import {expect, it} from 'vitest';

import {exponent, median, quotient} from '../../bench/numbers.mjs';
import {ratiosOf, summary} from '../../bench/ratios.mjs';

/** A case of the search: results of 1000 random starts and of the search, with their times. */
const searched = (garment: string, fits: readonly [number, number], times = [100, 10]) => ({
  garment,
  group: 'pmm',
  symmetry: 'auto',
  starts: {best: fits[0], milliseconds: times[0]},
  search: {fitSearch: fits[1], milliseconds: times[1]},
});

/** A method's result and times on every platform. */
const solved = (figures: {fit?: number; symmetries?: number; deformation?: number}) => {
  const {fit = 1, symmetries = 0, deformation = 1} = figures;
  const answer = {
    ...{fit, fitRandom: 100, fitDrafted: 50, fitSeam: fit, fitSeamRandom: 100, symmetries},
    milliseconds: {deformation, total: 2 * deformation},
    ...{firstAlignment: 1, progress: {monotone: true, astray: 0.1}},
  };
  return {native: answer, wasm: answer};
};

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

it('does without a garment for which a method failed', () => {
  const best = solved({fit: 3});
  const methods = [
    {garment: 'tee', group: 'pmm', best},
    {garment: 'apron', group: 'pmm', best: undefined},
  ];
  expect(ratio({methods}, 'fit / fitRandom')).toMatchObject({value: 0.03, cases: 1});
  expect(ratio({methods}, 'fit / fitDrafted')).toMatchObject({value: 0.06, cases: 1});
});

it('compares with the published method as it stands and at its best, where it gets worse, too', () => {
  const fits = (best: number, paper: number, bestPaper: number) => ({
    ...{group: 'pgg', best: {fit: best}, paper: {fit: paper}, bestPaper: {fit: bestPaper}},
  });
  const published = [
    {garment: 'tee', ...fits(3, 10, 6)},
    {garment: 'shirt', ...fits(6, 20, 5)},
    {garment: 'apron', ...fits(0, 5, 0)},
  ];
  expect(ratio({published}, 'fit best / paper')).toMatchObject({value: 0.3, cases: 3});
  expect(ratio({published}, 'fit best / best paper')).toMatchObject({value: 0.85, cases: 2});
  expect(ratio({published}, 'fit best / best paper', 'worst')).toMatchObject({
    ...{value: 1.2, met: false, worst: {name: 'shirt, pgg'}},
  });
});

it('compares times with and without symmetry only where there is one', () => {
  const slow = solved({deformation: 90});
  const methods = [
    {garment: 'tee', group: 'pmm', best: solved({symmetries: 2, deformation: 45}), none: slow},
    {garment: 'wrap', group: 'pmm', best: slow, none: slow},
  ];
  expect(ratio({methods}, 'deformation time')).toMatchObject({value: 0.5, cases: 1});
});

it('says nothing of what was not measured', () => {
  expect(ratiosOf({})).toEqual([]);
});
