/** Texts of pieces on pages: complete on one page where the piece has room. */
import {expect, it} from 'vitest';

import {pagesOf} from '@/paper/cutting-pdf.js';
import {boxOfMark} from '@/paper/draw-marks.js';
import {drawFirstPage} from '@/paper/first-page.js';
import {paperOf} from '@/paper/papers.js';
import {marksOnPages} from '@/paper/words-on-page.js';

import type {CutText} from '@/cutting/cut-sheet.js';

import {laidRectangle, sheetOf} from '../../support/paper/cut-sheets.js';
import {readableText} from '../../support/paper/readable-text.js';

const a4 = paperOf('a4') ?? {name: 'none', widthCm: 0};

it.each([
  ['moves them off a joint', 40, 30],
  ['moves them off a corner of four pages', 37, 50],
])('%s', (_, width, height) => {
  const sheet = sheetOf(width, height);
  const [piece = laidRectangle(1, 1)] = sheet.pieces;
  const {pages} = pagesOf(sheet, a4);
  const marks = marksOnPages(piece, pages);
  const [before, after] = [piece.marks, marks].map((some) =>
    some.flatMap((mark) => (mark.layer === 'words' ? [boxOfMark(mark)] : [])),
  );
  const isWhole = ({low, high}: ReturnType<typeof boxOfMark>): boolean =>
    pages.some(
      ({frame}) =>
        frame.low[0] <= low[0] &&
        frame.low[1] <= low[1] &&
        frame.high[0] >= high[0] &&
        frame.high[1] >= high[1],
    );
  expect(before?.map(isWhole)).toEqual([false]);
  expect(after?.map(isWhole)).toEqual([true]);
  expect(marks.filter(({layer}) => layer !== 'words')).toEqual(
    piece.marks.filter(({layer}) => layer !== 'words'),
  );
});

it('leaves them where there is no room, and where they are whole', () => {
  const thin = sheetOf(60, 2.2);
  const small = sheetOf(10, 10);
  for (const sheet of [thin, small]) {
    const [piece = laidRectangle(1, 1)] = sheet.pieces;
    expect(marksOnPages(piece, pagesOf(sheet, a4).pages)).toEqual(piece.marks);
  }
});

it('moves each other text, and the name of a narrow piece, off joints by the shortest way', () => {
  const sheet = sheetOf(40, 2.6);
  const [piece = laidRectangle(1, 1)] = sheet.pieces;
  const {pages} = pagesOf(sheet, a4);
  const joint = pages[0]?.frame.high[0] ?? 0;
  const texts = (['marks', 'words'] as const).map((layer): CutText => ({
    ...{kind: 'text', layer, at: [joint - 0.1, 1.3], lines: ['Ab'], sizeMm: 5, hasPlate: true},
  }));
  const moved = marksOnPages({...piece, marks: texts}, pages);
  for (const mark of moved) {
    const {low, high} = boxOfMark(mark);
    expect(pages.some(({frame}) => frame.low[0] <= low[0] && frame.high[0] >= high[0])).toBe(true);
    expect(Math.abs((low[0] + high[0]) / 2 - joint)).toBeLessThan(1.5);
  }
});

it('puts a plate under each name of a page on the map', () => {
  const sheet = sheetOf(60, 60);
  const layout = pagesOf(sheet, a4);
  const names = layout.pages.flatMap(({name}) => name ?? []);
  const plates =
    drawFirstPage(sheet, layout, readableText()).match(/1 1 1 rg\n[^\n]* re\nf/g) ?? [];
  expect(names.length).toBeGreaterThan(1);
  expect(plates).toHaveLength(names.length);
});
