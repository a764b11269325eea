import {describe, expect, it} from 'vitest';

import {pickIndex, type PickIndex} from '@/clicks/pick-index.js';
import {
  inwards,
  nextPiece,
  nextSeam,
  outwards,
  readingOrder,
  seamsRound,
  twin,
  type Direction,
  type SeamPlace,
} from '@/clicks/walk.js';
import {dartedLoop, rectangle, sewnSquares, sheetOf} from '../../support/clickable-sheet.js';

const piece = (
  width: number,
  height: number,
  x: number,
  y: number,
): Parameters<typeof sheetOf>[0][number] => ({loop: rectangle(width, height), offset: [x, y]});

/**
 * Two rows, each aligned at its lower edge:
 *   3 (tall)  0 (short)  1 (tall)
 *     4          2
 */
const rows = (): PickIndex =>
  pickIndex(
    sheetOf([
      piece(10, 8, 12, 30),
      piece(10, 30, 24, 30),
      piece(14, 20, 18, 0),
      piece(10, 30, 0, 30),
      piece(14, 20, 1, 0),
    ]),
  );

/**
 * A square with a dart in its upper side, whose lower side is sewn to another; the file's numbers
 * in order.
 */
const darted = (): PickIndex =>
  pickIndex(
    sheetOf(
      [{loop: dartedLoop}, piece(8, 8, 0, -20)],
      [
        [
          [0, 4, 3],
          [0, 4, 5],
        ],
        [
          [1, 3, 2],
          [0, 0, 1],
        ],
      ],
    ),
  );

const seamPlace = (on: number, seam: number, side: 'a' | 'b'): SeamPlace => ({
  level: 'seam',
  piece: on,
  seam,
  side,
});

describe('the reading order', () => {
  it('goes row by row from above, each row from the left', () => {
    expect(readingOrder(rows())).toEqual([3, 0, 1, 4, 2]);
  });

  it('is empty without pieces', () => {
    expect(readingOrder(pickIndex(sheetOf([])))).toEqual([]);
  });
});

describe('an arrow', () => {
  const to = (from: number, direction: Direction): number => nextPiece(rows(), from, direction);

  it('goes to the neighbour in the row, be it ever so short', () => {
    expect(to(3, 'right')).toBe(0);
    expect(to(1, 'left')).toBe(0);
  });

  it('goes to the piece below or above that lies nearest', () => {
    expect(to(3, 'down')).toBe(4);
    expect(to(1, 'down')).toBe(2);
    expect(to(2, 'up')).toBe(1);
    expect(to(4, 'up')).toBe(3);
  });

  it('stays where there is nothing further', () => {
    expect(to(3, 'left')).toBe(3);
    expect(to(3, 'up')).toBe(3);
    expect(to(1, 'right')).toBe(1);
    expect(to(2, 'down')).toBe(2);
  });

  it('stays on a piece that is not there', () => {
    expect(to(9, 'left')).toBe(9);
  });

  it('reaches every piece with others', () => {
    const index = rows();
    const reached = new Set([0]);
    for (const from of reached)
      for (const direction of ['left', 'right', 'up', 'down'] as const)
        reached.add(nextPiece(index, from, direction));
    expect([...reached].sort()).toEqual([0, 1, 2, 3, 4]);
  });
});

describe('the seams of a piece', () => {
  it('come counter-clockwise round the outline, both legs of a dart', () => {
    expect(seamsRound(darted(), 0)).toEqual([
      seamPlace(0, 1, 'b'),
      seamPlace(0, 0, 'a'),
      seamPlace(0, 0, 'b'),
    ]);
  });

  it('are entered at the first', () => {
    expect(inwards(darted(), {level: 'piece', piece: 0})).toEqual(seamPlace(0, 1, 'b'));
  });

  it('are not entered from a piece without any', () => {
    const place = {level: 'piece', piece: 3} as const;
    expect(inwards(rows(), place)).toBe(place);
  });

  it('have nothing further inside', () => {
    const place = seamPlace(0, 0, 'a');
    expect(inwards(darted(), place)).toBe(place);
  });

  it('follow each other in a circle', () => {
    const index = darted();
    expect(nextSeam(index, seamPlace(0, 1, 'b'), 1)).toEqual(seamPlace(0, 0, 'a'));
    expect(nextSeam(index, seamPlace(0, 0, 'b'), 1)).toEqual(seamPlace(0, 1, 'b'));
    expect(nextSeam(index, seamPlace(0, 1, 'b'), -1)).toEqual(seamPlace(0, 0, 'b'));
  });

  it('lead to their twins and back', () => {
    const index = pickIndex(sewnSquares());
    const there = twin(index, seamPlace(0, 0, 'a'));
    expect(there).toEqual(seamPlace(1, 0, 'b'));
    expect(twin(index, there)).toEqual(seamPlace(0, 0, 'a'));
  });

  it('lead from one leg of a dart to the other', () => {
    expect(twin(darted(), seamPlace(0, 0, 'a'))).toEqual(seamPlace(0, 0, 'b'));
  });

  it('lead out to their piece, and from there off the sheet', () => {
    const out = outwards(seamPlace(1, 0, 'b'));
    expect(out).toEqual({level: 'piece', piece: 1});
    expect(out && outwards(out)).toBeUndefined();
  });
});
