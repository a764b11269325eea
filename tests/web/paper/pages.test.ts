import {describe, expect, it} from 'vitest';

import type {Point} from '@/model/geometry/vectors.js';
import {cornersOf, overlap, reachesInto} from '@/paper/boxes.js';
import {pagesOf, sheetFor} from '@/paper/cutting-pdf.js';
import {drawFirstPage} from '@/paper/first-page.js';
import {paperOf, type Paper} from '@/paper/papers.js';
import {laidRectangle, sheetOf} from '../../support/paper/cut-sheets.js';
import {readableText} from '../../support/paper/readable-text.js';

function paper(name: string): Paper {
  const found = paperOf(name);
  if (!found) throw new Error(name);
  return found;
}

/** A square ring of the sheet's size, so that pages in its middle are empty. */
const frame = (side: number, width: number) =>
  sheetOf(side, side, [
    laidRectangle(side, width),
    laidRectangle(side, width, {place: {angle: 0, translation: [0, side - width]}}),
    laidRectangle(width, side),
    laidRectangle(width, side, {place: {angle: 0, translation: [side - width, 0]}}),
  ]);

describe('papers', () => {
  it('are known by name, and by size in any unit', () => {
    expect(paper('A4')).toMatchObject({widthCm: 21, heightCm: 29.7});
    expect(paper('tabloid').heightCm).toBeCloseTo(43.18, 6);
    expect(paper('90x60')).toMatchObject({widthCm: 60, heightCm: 90});
    expect(paper('600x900mm')).toMatchObject({widthCm: 60, heightCm: 90});
    expect(paper('24x36in').widthCm).toBeCloseTo(60.96, 6);
    expect(paper('36in').heightCm).toBeUndefined();
    for (const none of ['a9', '5x5', '60x', '60x9000', '600x600in', 'constructor', '-2x30']) {
      expect(paperOf(none), none).toBeUndefined();
    }
  });
});

describe('pages of paper', () => {
  it('have room for a name of any length, which is cut off with an ellipsis', () => {
    const sheet = {...sheetOf(10, 10), heading: 'dress_pencil_specification_'.repeat(6)};
    const layout = pagesOf(sheet, paper('a4'));
    const [left, right] = [layout.block.low[0], layout.block.high[0]];
    expect(right - left).toBeLessThan(21);
    const resources = readableText();
    expect(drawFirstPage(sheet, layout, resources)).toMatch(/dress_pencil\w*…\)/);
    expect(drawFirstPage(sheetOf(10, 10), layout, resources)).toContain('(Apron, M)');
  });

  it('are all of their rows and columns if blank ones are kept', () => {
    const sheet = frame(150, 20);
    const {pages, columns, rows, empty} = pagesOf(sheet, {...paper('a4'), keepsBlank: true});
    expect(pages.filter(({name}) => name !== undefined)).toHaveLength(columns * rows);
    expect(empty).toEqual([]);
    expect(pagesOf(sheet, paper('a4')).empty.length).toBeGreaterThan(0);
  });

  it.each(['a4', 'letter', 'a3', 'legal', 'tabloid', 'a1', 'a0', '36in', 'projector', '40x70'])(
    'cover all that is cut, on %s',
    (name) => {
      const sheet = frame(150, 20);
      const {pages, widthCm, heightCm} = pagesOf(sheet, paper(name));
      const isSeen = ([x, y]: Point): boolean =>
        pages.some(
          ({window: {low, high}}) => x >= low[0] && x <= high[0] && y >= low[1] && y <= high[1],
        );
      for (let k = 0; k <= 300; k++) {
        for (const p of [[k / 2, 0] as const, [20, k / 2] as const, [k / 2, 150] as const]) {
          expect(isSeen(p), String(p)).toBe(true);
        }
      }
      for (const {low, window} of pages) {
        expect(window.low[0]).toBeGreaterThanOrEqual(low[0] - 1e-9);
        expect(window.high[0]).toBeLessThanOrEqual(low[0] + widthCm + 1e-9);
        expect(window.high[1]).toBeLessThanOrEqual(low[1] + heightCm + 1e-9);
      }
    },
  );

  it('overlap by 1 cm where they are glued, and leave out what is empty', () => {
    const {pages, columns, rows, empty} = pagesOf(frame(150, 20), paper('a4'));
    const named = pages.filter(({name}) => name !== undefined);
    expect(named.length + empty.length).toBe(columns * rows);
    expect(empty.length).toBeGreaterThan(10);
    const [first, second] = named;
    expect(first?.name).toBe('1A');
    expect(second?.name).toBe('1B');
    expect((first?.window.high[0] ?? 0) - (second?.window.low[0] ?? 0)).toBeCloseTo(1, 9);
    expect((first?.window.high[0] ?? 0) - (first?.frame.high[0] ?? 0)).toBeCloseTo(1, 9);
  });

  it('turn the paper where that takes fewer', () => {
    expect(pagesOf(sheetOf(27, 10), paper('a4'))).toMatchObject({widthCm: 29.7, heightCm: 21});
    expect(pagesOf(sheetOf(10, 27), paper('a4'))).toMatchObject({widthCm: 21, heightCm: 29.7});
  });

  it('have words and squares where no piece is, or on a page before', () => {
    const apart = pagesOf(sheetOf(60, 60), paper('a0'));
    expect(apart.pages.map(({name}) => name)).toEqual(['1A']);
    const [piece] = sheetOf(60, 60).pieces;
    expect(piece && reachesInto(piece.cut, apart.block)).toBe(false);
    const full = pagesOf(sheetOf(80, 115), paper('a0'));
    expect(full.pages.map(({name}) => name)).toEqual([undefined, '1A']);
    const cover = full.pages[0];
    expect(cover && overlap(cover.window, {low: [0, 0], high: [80, 115]})).toBe(false);
  });

  it('grow on a roll and for a projector, and no page is longer than readers show', () => {
    const roll = pagesOf(sheetOf(80, 300), paper('36in'));
    expect(roll.widthCm).toBeCloseTo(91.44, 6);
    expect(roll.pages).toHaveLength(1);
    expect(roll.heightCm).toBeGreaterThan(302);
    const long = pagesOf(sheetOf(80, 900), paper('36in'));
    expect(long.heightCm).toBeLessThanOrEqual(500);
    expect(long.pages.length).toBeGreaterThan(1);
    const wall = pagesOf(sheetOf(30, 40), paper('projector'));
    expect(wall.pages).toHaveLength(1);
    const [piece] = sheetOf(30, 40).pieces;
    expect(piece && reachesInto(piece.cut, wall.block)).toBe(false);
    for (const corner of cornersOf(wall.block)) {
      const [low] = wall.pages.map((page) => page.low);
      expect(corner[0]).toBeGreaterThanOrEqual(low?.[0] ?? 0);
      expect(corner[1]).toBeLessThanOrEqual((low?.[1] ?? 0) + wall.heightCm);
    }
  });

  it('come of the sheet that takes the fewest', () => {
    const lay = (aspect: number) => (aspect < 1 ? sheetOf(80, 150) : sheetOf(110, 150 / 1.4));
    expect(sheetFor(paper('36in'), lay).widthCm).toBe(80);
  });
});
