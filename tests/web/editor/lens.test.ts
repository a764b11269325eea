import {describe, expect, it} from 'vitest';

import {rulerOf} from '@/scene/ruler.js';
import {nextWorst, rankOf} from '@/workbench/lists/rows.js';
import {seamRow as row} from '../../support/seam-row.js';

/** Order by mismatch: 2, 0, 1; seam 3 does not count. */
const rows = [row(0, 2), row(1, 1), row(2, 3), row(3, 9, false)];

describe('the walk from seam to seam', () => {
  it('goes from the worst down, and round', () => {
    expect([2, 0, 1].map((seam) => nextWorst(rows, seam, 1))).toEqual([0, 1, 2]);
    expect([2, 0, 1].map((seam) => nextWorst(rows, seam, -1))).toEqual([1, 2, 0]);
  });

  it('starts at the worst from a seam that does not count', () => {
    expect(nextWorst(rows, 3, 1)).toBe(2);
    expect(nextWorst(rows, 3, -1)).toBe(1);
    expect(nextWorst([], undefined, 1)).toBeUndefined();
  });

  it('tells how many are worse', () => {
    expect(rankOf(rows, 0)).toEqual({rank: 2, count: 3});
    expect(rankOf(rows, 3)).toBeUndefined();
  });
});

describe('a ruler', () => {
  it('has a tick every 5 mm where there is room', () => {
    expect(rulerOf(10, 60, 20, 'cm')).toEqual({step: 0.5, ticks: [10, 20, 30, 40, 50, 60, 70]});
  });

  it('has a tick every centimetre, or fewer, where there is none', () => {
    expect(rulerOf(0, 100, 10, 'cm').step).toBe(1);
    expect(rulerOf(0, 100, 2, 'cm').step).toBe(5);
  });

  it('has parts of an inch for whoever measures in inches', () => {
    expect(rulerOf(0, 100, 20, 'inch').step).toBeCloseTo(0.25 * 2.54, 12);
  });
});
