import {describe, expect, it} from 'vitest';

import type {Point} from '@/model/geometry/vectors.js';
import type {Box} from '@/viewer/chips.js';
import {spotFor, type Anchor} from '@/viewer/ranks.js';

const size = {width: 400, height: 300};
/** Anchors on an edge that runs down the screen at x = 100; the piece is on its left. */
const anchors: readonly Anchor[] = [
  {at: [100, 100], out: [1, 0]},
  {at: [100, 150], out: [1, 0]},
];
const cloth = ([x]: Point): boolean => x < 100;
const middleOf = ({left, top, right, bottom}: Box): Point => [
  (left + right) / 2,
  (top + bottom) / 2,
];
const spot = (
  taken: readonly Box[],
  isOnFabric = cloth,
): {at: Point; reach: number} | undefined => {
  const found = spotFor(anchors, size, taken, isOnFabric);
  return found && {at: middleOf(found.box), reach: found.reach};
};

describe('the rank of a seam', () => {
  it('stands right beside the place where the seam misses most', () => {
    expect(spot([])).toEqual({at: [115, 100], reach: 15});
  });

  it('rather goes along the seam than far from it, where a name or another rank is in its way', () => {
    const name = {left: 95, top: 80, right: 200, bottom: 120};
    expect(spot([name])).toEqual({at: [115, 150], reach: 15});
  });

  it('moves off where all of the seam is taken, by no more than it must', () => {
    const beside = [100, 150].map((y) => ({left: 112, top: y - 30, right: 130, bottom: y - 4}));
    const {at = [0, 0], reach = 0} = spot(beside) ?? {};
    expect({at, reach}).toEqual({at: [140, 100], reach: 40});
  });

  it('rather stands inside of the seam than on a line across a name', () => {
    const names = {left: 106, top: 50, right: 125, bottom: 200};
    expect(spot([names])).toEqual({at: [85, 100], reach: 15});
  });

  it('stands on no cloth while there is another place', () => {
    const neighbour = ([x, y]: Point): boolean => x < 100 || (x > 110 && y < 130);
    expect(spot([], neighbour)).toEqual({at: [115, 150], reach: 15});
    expect(spot([], () => true)).toEqual({at: [85, 100], reach: 15});
  });

  it('is not there where there is no room, or the seam is out of sight', () => {
    expect(spot([{left: 0, top: 0, right: 400, bottom: 300}])).toBeUndefined();
    expect(spotFor([{at: [500, 100], out: [1, 0]}], size, [], cloth)).toBeUndefined();
  });
});
