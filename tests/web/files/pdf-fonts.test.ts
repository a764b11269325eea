import {expect, it} from 'vitest';

import type {CutText} from '@/cutting/cut-sheet.js';
import {sansGlyph} from '@/files/pdf/fonts/letters.js';
import {subsetOf} from '@/files/pdf/fonts/subset.js';
import {readTrueType} from '@/files/pdf/fonts/true-type.js';
import {lettersFrom} from '@/node/letters.js';
import {cuttingPdf} from '@/paper/cutting-pdf.js';
import {laidRectangle, sheetOf} from '../../support/paper/cut-sheets.js';
import {readPdf} from '../../support/paper/pdf.js';

const print = {group: 'p1', w1: [5, 0], w2: [0, 5]} as const;
const paper = {name: 'A0', widthCm: 84.1, heightCm: 118.9};

it('embeds a Japanese label from the font of the package', async () => {
  const label = '前身頃 Front';
  const text: CutText = {
    kind: 'text',
    layer: 'words',
    at: [20, 20],
    lines: [label],
    sizeMm: 7,
    hasPlate: false,
  };
  const sheet = sheetOf(40, 40, [{...laidRectangle(40, 40), label, marks: [text]}]);
  const {bytes, notes} = await cuttingPdf(sheet, print, {paper, letters: lettersFrom()});
  expect(notes).toEqual([]);
  const maps = [...readPdf(bytes).objects.values()].map(({stream = ''}) => stream);
  for (const letter of '前身頃') {
    const unit = letter.charCodeAt(0).toString(16);
    expect(
      maps.some((map) => map.includes(`> <${unit}>`)),
      letter,
    ).toBe(true);
  }
});

it('names letters that no font has', async () => {
  const sheet = {...sheetOf(40, 40), heading: '한'};
  const {notes} = await cuttingPdf(sheet, print, {paper, letters: lettersFrom()});
  expect(notes).toEqual([expect.stringContaining('letters 한,')]);
});

it('keeps outlines and widths of glyphs in a subset, and the parts of composite ones', async () => {
  const font = await lettersFrom().fontFor?.('が');
  if (!font) throw new Error('no font');
  const {glyphOf, widthOf, outlineOf} = font.font;
  const glyph = glyphOf('が'.codePointAt(0) ?? 0);
  const bytes = subsetOf(font.font, [0, glyph]);
  const subset = await readTrueType(bytes, 'subset');
  expect(subset.widthOf(1)).toBe(widthOf(glyph));
  expect(subset.outlineOf(1).slice(0, 10)).toEqual(outlineOf(glyph).slice(0, 10));
});

it('reads no other fonts', async () => {
  const bytes = new TextEncoder().encode('OTTO and more bytes than a head has');
  await expect(readTrueType(new Uint8Array(bytes), 'my.otf')).rejects.toThrow(
    /^my\.otf is no font/,
  );
});

it('has the letters of European languages', () => {
  const letters = 'ąčđęğħıļńőřşťůžțΩψЖщђґ’„“…€№→×°';
  expect(Array.from(letters).filter((one) => sansGlyph(one.codePointAt(0) ?? 0) === 0)).toEqual([]);
});
