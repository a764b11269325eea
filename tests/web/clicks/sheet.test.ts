import {describe, expect, it} from 'vitest';

import {inputPoint, type Sheet} from '@/clicks/sheet.js';
import {targetsAt} from '@/clicks/pick.js';
import {pickIndex} from '@/clicks/pick-index.js';
import {sceneOf} from '@/scene/scene.js';
import {rectangle, sheetOf} from '../../support/clickable-sheet.js';
import {plainPrint, squarePair} from '../../support/garments/two-squares.js';

describe('a sheet for clicks', () => {
  it('can be a scene of the viewer', () => {
    const scene: Sheet = sceneOf(squarePair(), plainPrint);
    const [x = NaN, y = NaN] = scene.pieces[1]?.offset ?? [];
    const [target] = targetsAt(pickIndex(scene), [x + 2, y + 3], 0.1);
    expect(target).toMatchObject({kind: 'piece', piece: 1});
  });
});

describe('a point in the coordinates of the file', () => {
  it('is the same for a piece as it was drafted', () => {
    expect(inputPoint(sheetOf([{loop: rectangle(4, 4)}]), 0, [1, 3])).toEqual([1, 3]);
  });

  it('has its x negated for a piece that was turned over on reading', () => {
    const sheet = sheetOf([{loop: rectangle(4, 4), mirroredFromInput: true}]);
    expect(inputPoint(sheet, 0, [1, 3])).toEqual([-1, 3]);
  });

  it('goes back with its triangle where the piece is shown deformed', () => {
    // drafted as a square, shown twice as wide and moved up by 1
    const sheet = sheetOf([
      {
        loop: [
          [0, 1],
          [8, 1],
          [8, 5],
          [0, 5],
        ],
        rest: rectangle(4, 4),
        triangles: [
          [0, 1, 2],
          [0, 2, 3],
        ],
      },
    ]);
    const [x, y] = inputPoint(sheet, 0, [2, 4]); // a point in the upper left triangle
    expect(x).toBeCloseTo(1, 12);
    expect(y).toBeCloseTo(3, 12);
  });

  it('goes back with the nearest triangle from just outside a deformed piece', () => {
    const sheet = sheetOf([
      {
        loop: [
          [0, 0],
          [4, 0],
          [4, 5],
          [0, 4],
        ],
        rest: rectangle(4, 4),
        triangles: [
          [0, 1, 2],
          [0, 2, 3],
        ],
      },
    ]);
    const [x, y] = inputPoint(sheet, 0, [4.1, 2.5]);
    expect(x).toBeCloseTo(4.1, 12);
    expect(y).toBeCloseTo(2, 12);
  });
});
