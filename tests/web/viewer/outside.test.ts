/** Placement of an edge's lines outside of the piece. */
import {describe, expect, it} from 'vitest';

import type {Point} from '@/model/geometry/vectors.js';
import {endsOnOutline, outsideOf, shiftsOutside} from '@/viewer/outside.js';

const square: readonly Point[] = [
  [0, 0],
  [4, 0],
  [4, 4],
  [0, 4],
];
const outline = [0, 1, 2, 3];

const first = (shifts: readonly Point[]): Point => shifts[0] ?? [NaN, NaN];

describe('a line beside an edge', () => {
  it('lies away from the piece, whichever way its seam is sewn', () => {
    const piece = {outline, holes: []};
    const [, down] = first(shiftsOutside(square.slice(0, 2), outsideOf(piece, [0, 1])));
    expect(down).toBeLessThan(0);
    const [, back] = first(shiftsOutside(square.slice(0, 2).reverse(), outsideOf(piece, [1, 0])));
    expect(back).toBeCloseTo(down, 12);
  });

  it('covers the edge itself by a little, and no more', () => {
    const [, down] = first(shiftsOutside(square.slice(0, 2), 1));
    expect(down).toBeGreaterThan(-0.5);
    expect(down).toBeLessThan(-0.35);
  });

  it('keeps its distance from both edges of a corner', () => {
    const shifts = shiftsOutside(square, 1, true);
    const [x, y] = first(shifts);
    expect(x).toBeCloseTo(y, 12);
    const [, straight] = first(shiftsOutside(square.slice(0, 2), 1));
    expect(y).toBeCloseTo(straight, 12);
  });

  it('does not run away from a tip as thin as a needle', () => {
    const needle: readonly Point[] = [
      [0, 0],
      [100, 0.01],
      [0, 0.02],
    ];
    for (const [x, y] of shiftsOutside(needle, 1, true)) expect(Math.hypot(x, y)).toBeLessThan(1);
  });

  it('lies inside a cut-out, where there is no cloth', () => {
    const piece = {outline: [...outline], holes: [[4, 7, 6, 5]]};
    const hole: readonly Point[] = [
      [1, 1],
      [1, 3],
    ];
    const [right] = first(shiftsOutside(hole, outsideOf(piece, [4, 7])));
    expect(right).toBeGreaterThan(0);
  });
});

it('ends an axis where it leaves the cloth, also in a neckline that is scooped', () => {
  const points: readonly Point[] = [
    [0, 0],
    [4, 0],
    [4, 5],
    [2, 3],
    [0, 5],
  ];
  const ends = endsOnOutline({points, outline: [0, 1, 2, 3, 4]}, [
    [2, 0],
    [2, 5],
  ]);
  expect(ends.map(({at}) => at[1])).toEqual([0, 3]);
  expect(ends.map(({out}) => out[1])).toEqual([-1, 1]);
});
