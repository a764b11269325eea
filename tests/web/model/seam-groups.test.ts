import {describe, expect, it} from 'vitest';

import type {SeamGroup, SolveResult} from '@/model/result/result.js';
import {
  isVisible,
  mismatchAlong,
  quietSeams,
  seamCount,
  stateAt,
} from '@/model/result/seam-groups.js';
import {countAt, seamGroupsOf} from '@/scene/group-states.js';
import {plainMetrics, squarePair} from '../../support/garments/two-squares.js';

const group = (seam: number, more: Partial<SeamGroup> = {}): SeamGroup => ({
  ...{seams: [seam], place: 'side', visibility: 2, state: 'matches'},
  ...more,
});

describe('the count of seams', () => {
  const groups = [
    group(0),
    group(1, {state: 'close', reason: 'others'}),
    group(2, {state: 'choice'}),
    group(3, {state: 'cannot', reason: 'gather'}),
    group(4, {state: 'cannot', reason: 'grain'}),
    group(5, {visibility: 0.5, state: 'off'}),
  ];

  it('leaves out hidden seams, gathers and what the user has left out', () => {
    expect(seamCount(groups, undefined)).toEqual({matched: 1, counted: 3});
    expect(isVisible(group(3, {state: 'cannot', reason: 'gather'}), undefined)).toBe(false);
  });

  it('are quiet where they neither count nor match', () => {
    expect([...quietSeams([...groups, group(6, {visibility: 0.5})], undefined)]).toEqual([2, 3, 5]);
  });

  it('follows a weight of the user rather than the place', () => {
    expect(seamCount(groups, {1: 0.5, 5: 3})).toEqual({matched: 1, counted: 3});
    expect(seamCount(groups, {1: 0.5, 4: 0.5})).toEqual({matched: 1, counted: 1});
  });

  it('is of the hidden seams in a garment that has no others', () => {
    const hidden = groups.map((one) => ({...one, visibility: 0.5}));
    expect(seamCount(hidden, undefined)).toEqual({matched: 1, counted: 4});
    expect(seamCount([], undefined)).toEqual({matched: 0, counted: 0});
  });
});

describe('the mismatch of a seam', () => {
  it('is what 95 % of its length stay within', () => {
    const lengths = Array<number>(20).fill(1);
    const off = (bad: number) => lengths.map((_, k) => (k < bad ? 5 : 0.2));
    expect(mismatchAlong([{lengths, mismatch: off(1)}])).toBe(0.2);
    expect(mismatchAlong([{lengths, mismatch: off(2)}])).toBe(5);
    expect(mismatchAlong([])).toBe(0);
  });

  it('gives a state by steps of 3 mm', () => {
    expect([0.3, 0.31, 0.6, 0.61].map(stateAt)).toEqual(['matches', 'close', 'close', 'off']);
  });
});

describe('a result of an earlier version', () => {
  const result: SolveResult = {
    ...{format: 'seamwise-result/1', units: 'cm', search: [], metrics: plainMetrics, notes: []},
    ...squarePair(),
  };

  it('has a visible seam for each stitch, with the state of its mismatch', () => {
    expect(seamGroupsOf(result)).toEqual([
      {seams: [0], place: 'other', visibility: 1.5, state: 'matches'},
    ]);
    const seams = result.seams.map((seam) => ({...seam, matched: false}));
    expect(seamGroupsOf({...result, seams})).toMatchObject([{state: 'choice'}]);
  });

  it('counts the same seams for the pieces as drafted', () => {
    const drafted = [{mismatch: [0.4], lengths: [4], counts: true}];
    expect(countAt(seamGroupsOf(result), undefined, drafted)).toEqual({matched: 0, counted: 1});
  });
});
