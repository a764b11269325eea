import {describe, expect, it} from 'vitest';

import {addedPage, cellAt, movedPage, placesOf} from '@/app/import/page-places.js';
import type {AssembledPages} from '@/model/garment/imported-drawing.js';

/** Pages 5 to 8 in two columns and rows of 100 x 200 mm, from the upper left. */
const pages: AssembledPages = {
  ...{count: 9, others: [], columns: 2, rows: 2, openJoints: []},
  placed: [5, 6, 7, 8].map((number, k) => {
    const [column, row] = [k % 2, Math.floor(k / 2)];
    const [x, y] = [100 * column, -200 * (row + 1)];
    return {number, cell: [column, row], low: [x, y], high: [x + 100, y + 200]};
  }),
};
const places = placesOf(pages);
const cellsOf = (some: typeof places): unknown =>
  Object.fromEntries(some.map(({number, cell}) => [number, cell]));

describe('a dragged page', () => {
  it('changes places with the page where it is dropped', () => {
    const to = cellAt(pages, [150, -300]);
    expect(to).toEqual([1, 1]);
    expect(cellsOf(movedPage(places, 5, to))).toEqual({5: [1, 1], 6: [1, 0], 7: [0, 1], 8: [0, 0]});
  });

  it('may begin a column or a row beside the others', () => {
    const to = cellAt(pages, [-400, -100]);
    expect(to).toEqual([-1, 0]);
    expect(cellsOf(movedPage(places, 8, to))).toEqual({5: [1, 0], 6: [2, 0], 7: [1, 1], 8: [0, 0]});
    expect(cellAt(pages, [50, -450])).toEqual([0, 2]);
  });
});

it('puts a page that was left out below the others', () => {
  expect(addedPage(places, 9).at(-1)).toEqual({number: 9, cell: [0, 2]});
});
