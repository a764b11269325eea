import {describe, expect, it} from 'vitest';

import {
  importanceOf,
  withGrain,
  withGrainLines,
  withImportance,
  withoutPin,
  withPrinted,
  withQuarterTurn,
} from '@/workbench/lists/changed-options.js';
import {inOrder} from '@/workbench/lists/row-order.js';

describe('the importance of a line of seams', () => {
  const line = [{seam: 3}, {seam: 5}];

  it('is undefined if its seams differ, or if a file has another weight', () => {
    expect(importanceOf({}, line)).toBe('usual');
    expect(importanceOf({weights: {3: 10}}, line)).toBeUndefined();
    expect(importanceOf({weights: {3: 10, 5: 10}}, line)).toBe('first');
    expect(importanceOf({weights: {3: 0.75, 5: 0.75}}, line)).toBeUndefined();
    expect(importanceOf({unmatched: [3, 5]}, line)).toBe('none');
  });

  it('changes without touching other seams', () => {
    const hardly = withImportance({weights: {1: 2}, unmatched: [4]}, [3, 5], 'hardly');
    expect(hardly).toEqual({weights: {1: 2, 3: 0.5, 5: 0.5}, unmatched: [4]});
    const none = withImportance(hardly, [3, 5], 'none');
    expect(none).toEqual({weights: {1: 2}, unmatched: [3, 4, 5]});
    expect(withImportance(none, [3, 5], 'usual')).toEqual({weights: {1: 2}, unmatched: [4]});
  });
});

describe('what is decided about one piece', () => {
  it('is a turn by 90 degrees, and back', () => {
    const across = withQuarterTurn({grain: {default: 'on'}}, 'band');
    expect(across.grain?.pieces).toEqual({band: 'across'});
    expect(withQuarterTurn(across, 'band').grain?.pieces).toEqual({band: 'on'});
    const all = withQuarterTurn({grain: {default: 'across'}}, 'band');
    expect(all.grain?.pieces).toEqual({band: 'on'});
  });

  it('is where its grain line runs, whatever is said of how it lies', () => {
    const lines = withGrainLines({grain: {pieces: {cuff: 'bias'}}}, {cuff: 0, band: 90});
    expect(lines.grain?.pieces).toEqual({
      cuff: {lock: 'bias', angleDeg: 0},
      band: {angleDeg: 90},
    });
    const turned = withQuarterTurn(lines, 'band');
    expect(turned.grain?.pieces?.band).toEqual({lock: 'across', angleDeg: 90});
    expect(withGrain(turned, 'band', 'all').grain?.pieces?.band).toEqual({angleDeg: 90});
  });

  it('is a grain of its own, or that of all', () => {
    const own = withGrain({grain: {default: 'on'}}, 'cuff', 'bias');
    expect(own.grain).toEqual({default: 'on', pieces: {cuff: 'bias'}});
    expect(withGrain(own, 'cuff', 'all').grain).toEqual({default: 'on', pieces: {}});
  });

  it('is plain fabric or print', () => {
    const plain = withPrinted({plain: ['yoke']}, 'cuff', false);
    expect(plain.plain).toEqual(['yoke', 'cuff']);
    expect(withPrinted(plain, 'cuff', true).plain).toEqual(['yoke']);
  });

  it('is a pin that can be taken out', () => {
    const pin = {angle: 0, translation: [0, 0]} as const;
    expect(withoutPin({pins: {cuff: pin, yoke: pin}}, 'cuff').pins).toEqual({yoke: pin});
  });
});

describe('rows in order', () => {
  const sorted = (rows: readonly (number | string | undefined)[], descending = false) =>
    inOrder(rows, (row) => row, descending, 'en');

  it('count up or down, with the unknown last', () => {
    expect(sorted([2, undefined, 10, 1])).toEqual([1, 2, 10, undefined]);
    expect(sorted([2, undefined, 10, 1], true)).toEqual([10, 2, 1, undefined]);
  });

  it('read numbers in names as numbers', () => {
    expect(sorted(['Panel 10', 'Panel 9', 'Cuff'])).toEqual(['Cuff', 'Panel 9', 'Panel 10']);
  });
});
