import {describe, expect, it} from 'vitest';

import {
  matchOf,
  withGrain,
  withGrainLines,
  withMatch,
  withoutPin,
  withPrinted,
  withQuarterTurn,
} from '@/workbench/lists/changed-options.js';
import {inOrder} from '@/workbench/lists/row-order.js';

const seam = {seam: 3, ownWeight: 1};

describe('how much a seam has to match', () => {
  it('is its weight, and whether it is matched at all', () => {
    expect(matchOf({matched: true, weight: 1})).toBe('full');
    expect(matchOf({matched: true, weight: 2})).toBe('double');
    expect(matchOf({matched: true, weight: 0.5})).toBe('half');
    expect(matchOf({matched: true, weight: 0.75})).toBeUndefined();
    expect(matchOf({matched: false, weight: 1})).toBe('none');
  });

  it('is said only where the garment file says otherwise', () => {
    expect(withMatch({weights: {1: 2}}, seam, 'half').weights).toEqual({1: 2, 3: 0.5});
    expect(withMatch({weights: {1: 2, 3: 0.5}}, seam, 'full').weights).toEqual({1: 2});
    expect(withMatch({}, {...seam, ownWeight: 0.5}, 'full').weights).toEqual({3: 1});
  });

  it('comes and goes without touching other seams', () => {
    const off = withMatch({unmatched: [1]}, seam, 'none');
    expect(off.unmatched).toEqual([1, 3]);
    expect(withMatch(off, seam, 'full').unmatched).toEqual([1]);
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

  it('is plain cloth or print', () => {
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
