import {describe, expect, it} from 'vitest';

import {choices, seamTarget, targetsAt, type Target} from '@/clicks/pick.js';
import {pickIndex} from '@/clicks/pick-index.js';
import type {Sheet} from '@/clicks/sheet.js';
import type {Point} from '@/model/geometry/vectors.js';
import {
  dartedSquare,
  manyRounds,
  pressesOn,
  rectangle,
  sewnSquares,
  sheetOf,
} from '../../support/clickable-sheet.js';

const at = (sheet: Sheet, point: Point, reach: number): readonly Target[] =>
  targetsAt(pickIndex(sheet), point, reach);

const kinds = (targets: readonly Target[]): readonly string[] => targets.map(({kind}) => kind);

describe('a press on the sheet', () => {
  it('finds the seam within reach, and where on it', () => {
    const [target] = at(sewnSquares(), [3.5, 1], 0.6);
    expect(target).toEqual({
      kind: 'seam',
      seam: 0,
      side: 'a',
      piece: 0,
      point: [4, 1],
      at: 0.25,
      edge: 3,
      distance: 0.5,
    });
  });

  it('finds a seam from outside of its piece, and no piece there', () => {
    const targets = at(sewnSquares(), [4.5, 3], 0.6);
    expect(kinds(targets)).toEqual(['seam']);
  });

  it('tells places on a moved piece in its own coordinates', () => {
    const [target] = at(sewnSquares(), [10.25, 3], 0.6);
    expect(target).toMatchObject({kind: 'seam', side: 'b', piece: 1, point: [0, 3], at: 0.75});
  });

  it('measures the share of a side by length, not by vertices', () => {
    const sheet = sheetOf(
      [
        {
          loop: [
            [0, 0],
            [1, 0],
            [4, 0],
            [4, 4],
          ],
          edges: [0, 0, 1, 2],
        },
      ],
      [
        [
          [0, 0, 1, 2],
          [0, 2, 3],
        ],
      ],
    );
    expect(at(sheet, [3, 0], 0.1)[0]).toMatchObject({side: 'a', at: 0.75, edge: 0});
  });

  it('counts the share in sewing order where that runs against the outline', () => {
    // side b runs from [0, 0] up, the outline down
    expect(at(sewnSquares(), [10, 1], 0.1)[0]).toMatchObject({side: 'b', at: 0.25, edge: 1});
  });

  it('finds an edge that is not sewn by its number in the file', () => {
    const [target] = at(sewnSquares(), [2, 0.25], 0.5);
    expect(target).toEqual({kind: 'edge', edge: 2, piece: 0, point: [2, 0], distance: 0.25});
  });

  it('takes an edge of many vertices for one, also across the start of the outline', () => {
    const sheet = sheetOf([
      {
        loop: [
          [2, 0],
          [4, 0],
          [4, 4],
          [0, 4],
          [0, 0],
        ],
        edges: [0, 1, 2, 3, 0],
      },
    ]);
    const targets = at(sheet, [2, 0.1], 0.5);
    expect(targets).toMatchObject([{kind: 'edge', edge: 0}, {kind: 'piece'}]);
  });

  it('does not know unsewn edges without their numbers', () => {
    const sheet = sheetOf([{loop: rectangle(4, 4)}]);
    expect(kinds(at(sheet, [2, 0.25], 0.5))).toEqual(['piece']);
  });

  it('knows seams without numbers, but not which edge they are', () => {
    const sheet = sheetOf(
      [{loop: rectangle(4, 4)}],
      [
        [
          [0, 0, 1],
          [0, 3, 2],
        ],
      ],
    );
    expect(at(sheet, [2, 0.25], 0.5)[0]).toMatchObject({kind: 'seam', edge: undefined});
  });

  it('puts lines before the piece, however close they are', () => {
    expect(kinds(at(sewnSquares(), [3.5, 2], 1))).toEqual(['seam', 'piece']);
  });

  it('puts the nearer of two lines first', () => {
    const near = (point: Point): readonly string[] => kinds(at(sewnSquares(), point, 1));
    expect(near([3.75, 0.5])).toEqual(['seam', 'edge', 'piece']);
    expect(near([3.5, 0.25])).toEqual(['edge', 'seam', 'piece']);
  });

  it('puts a seam before an edge where they meet', () => {
    expect(kinds(at(sewnSquares(), [4.25, -0.25], 1))).toEqual(['seam', 'edge']);
  });

  it('finds the piece away from all lines', () => {
    expect(at(sewnSquares(), [12, 1], 0.5)).toEqual([{kind: 'piece', piece: 1, point: [2, 1]}]);
  });

  it('finds nothing beside the pieces', () => {
    expect(at(sewnSquares(), [7, 2], 0.5)).toEqual([]);
  });

  it('finds nothing beyond reach, on the diagonal of a corner either', () => {
    expect(at(sewnSquares(), [-0.4, -0.4], 0.5)).toEqual([]);
  });

  it('does not take a cut-out for the piece', () => {
    const cutOut: Point[] = [
      [1, 1],
      [1, 3],
      [3, 3],
      [3, 1],
    ];
    const sheet = sewnSquares({cutOut});
    expect(at(sheet, [2, 2], 0.5)).toEqual([]);
    expect(kinds(at(sheet, [0.75, 2], 0.5))).toEqual(['piece']);
  });

  it('does not take the notch of a dart for the piece', () => {
    expect(at(dartedSquare(), [4, 7.5], 0.1)).toEqual([]);
  });
});

describe('the choices of a press', () => {
  it('are both legs of a dart near its tip', () => {
    const found = choices(at(dartedSquare(), [4, 3.75], 0.5), 0.1);
    expect(found).toMatchObject([
      {kind: 'seam', side: 'a', edge: 3},
      {kind: 'seam', side: 'b', edge: 4},
    ]);
  });

  it('leave out the other leg at the mouth of a dart', () => {
    const found = choices(at(dartedSquare(), [5, 8], 3), 0.1);
    expect(found).toMatchObject([{side: 'a'}, {kind: 'edge', edge: 2}]);
  });

  it('leave out lines that are further away than the tie', () => {
    const targets = at(sewnSquares(), [3.5, 0.25], 1);
    expect(kinds(choices(targets, 0.2))).toEqual(['edge']);
    expect(kinds(choices(targets, 0.3))).toEqual(['edge', 'seam']);
  });

  it('never tie a piece with a line', () => {
    expect(kinds(choices(at(sewnSquares(), [4, 2], 1), 100))).toEqual(['seam']);
  });

  it('are the piece alone where there is no line', () => {
    expect(kinds(choices(at(sewnSquares(), [2, 2], 0.5), 1))).toEqual(['piece']);
  });

  it('are none where there is nothing', () => {
    expect(choices([], 1)).toEqual([]);
  });
});

describe('a seam by its number', () => {
  it('is as if clicked in its middle', () => {
    expect(seamTarget(pickIndex(sewnSquares()), 0, 'b')).toEqual({
      kind: 'seam',
      seam: 0,
      side: 'b',
      piece: 1,
      point: [0, 2],
      at: 0.5,
      edge: 1,
      distance: 0,
    });
  });

  it('is nothing if there is none', () => {
    expect(seamTarget(pickIndex(sewnSquares()), 7, 'a')).toBeUndefined();
  });
});

describe('a large garment', () => {
  it('has a target wherever one of its outlines is pressed', () => {
    const index = pickIndex(manyRounds(40));
    for (const point of pressesOn(40, 1001)) {
      expect(targetsAt(index, point, 1).length).toBeGreaterThan(0);
    }
  });
});
