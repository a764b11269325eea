import {describe, expect, it} from 'vitest';

import {rulerOf} from '@/scene/ruler.js';

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
