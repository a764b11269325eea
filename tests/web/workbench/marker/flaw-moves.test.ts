/** Moving and resizing flaws of the fabric, by keys and by figures. */
import {describe, expect, it} from 'vitest';

import {boxAround, flawAfter, flawAround, flawIn} from '@/workbench/marker/marker-moves.js';
import type {Flaw} from '@/workbench/marker/lay-step.js';

const bolt = {widthCm: 140};
const triangle: Flaw = [
  [10, 20],
  [14, 20],
  [10, 26],
];
const pressed = (key: string, shiftKey = false): ReturnType<typeof flawAfter> =>
  flawAfter({key, shiftKey}, triangle, 'cm', bolt);

describe('a flaw', () => {
  it('is put around a place, on whole steps, and no further than the fabric goes', () => {
    expect(boxAround(flawAround([60.3, 40.2], 'cm', bolt))).toEqual({
      ...{left: 58, start: 38, width: 5, length: 5},
    });
    expect(boxAround(flawAround([139, 1], 'cm', bolt))).toMatchObject({left: 135, start: 0});
    expect(boxAround(flawAround([60, 40], 'inch', bolt)).width).toBeCloseTo(5.08);
  });

  it('keeps its outline when it is moved, and is told by its box', () => {
    expect(pressed('ArrowUp')).toEqual([
      [10, 21],
      [14, 21],
      [10, 27],
    ]);
    expect(flawIn(triangle, {left: 30, width: 8}, bolt)).toEqual([
      [30, 20],
      [38, 20],
      [30, 26],
    ]);
    expect(boxAround(flawIn(triangle, {left: -5}, bolt)).left).toBe(0);
    expect(boxAround(flawIn(triangle, {left: 139}, bolt)).left).toBe(136);
  });

  it('grows and shrinks from where it begins with Shift, and never to nothing', () => {
    expect(boxAround(pressed('ArrowRight', true) ?? [])).toMatchObject({left: 10, width: 5});
    expect(boxAround(pressed('ArrowDown', true) ?? [])).toMatchObject({start: 20, length: 5});
    const small = flawIn(triangle, {width: 0.6}, bolt);
    const smaller = flawAfter({key: 'ArrowLeft', shiftKey: true}, small, 'cm', bolt) ?? [];
    expect(boxAround(smaller).width).toBeCloseTo(0.5);
    const wide = flawIn(triangle, {width: 130}, bolt);
    expect(
      boxAround(flawAfter({key: 'ArrowRight', shiftKey: true}, wide, 'cm', bolt) ?? []),
    ).toEqual(boxAround(wide));
  });

  it('goes by Delete, and minds no other key', () => {
    expect([pressed('Delete'), pressed('r')]).toEqual([null, undefined]);
  });
});
