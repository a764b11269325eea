/** Motifs that cross borders of the print's cell are as complete as all others. */
import {describe, expect, it} from 'vitest';

import {draftedSheet} from '@/cutting/drafted-sheet.js';
import type {CutSheet} from '@/cutting/cut-sheet.js';
import {paperOf} from '@/paper/papers.js';
import {readGarment} from 'seamwise/node';
import {sample} from '../../support/garments/samples.js';
import {laidRectangle, onPrintAt, sheetOf} from '../../support/paper/cut-sheets.js';
import {comparedSheet, printedCell} from '../../support/paper/printed-sheet.js';
import {drawnPages} from '../../support/paper/draw-page.js';
import {installed} from '../../support/paper/renderers.js';
import type {Comparison} from '../../support/paper/whole-print.js';

/** Shares of pixels below this are noise of single pixels. */
const noise = 2e-4;

function expectWhole({near, elsewhere}: Comparison): void {
  expect(near.pixels).toBeGreaterThan(1000);
  expect(near.wrong / near.pixels).toBeLessThan(elsewhere.wrong / elsewhere.pixels + noise);
}

const paper = (word: string) => paperOf(word) ?? {name: 'none', widthCm: 0};

describe('a motif on the border of the cell', () => {
  it.each(['svg', 'png'] as const)('is whole in a print from %s', async (kind) => {
    const sheet = sheetOf(11, 11, [laidRectangle(11, 11, onPrintAt(0.3, [3.1, 1.7]))]);
    const cell = await printedCell('cm', kind);
    expectWhole(await comparedSheet(sheet, cell, {paper: paper('13.4x13.4'), render: drawnPages}));
  });
});

/** A garment with each piece at another place of the print, and every second one turned. */
async function scattered(garment: Parameters<typeof sample>[0]): Promise<CutSheet> {
  const sheet = draftedSheet(await readGarment(sample(garment)), {allowanceCm: 1, units: 'cm'});
  const pieces = sheet.pieces.map((piece, k) => ({
    ...piece,
    ...onPrintAt(k % 2 === 0 ? 0 : 0.3 * k, [3.1 * k, 1.7 * k]),
  }));
  return {...sheet, pieces};
}

const garments = ['tee', 'shirt', 'apron', 'hoodie', 'trousers', 'princess-dress'] as const;
const prints = [
  ...['bouquet', 'check', 'cm', 'cmm', 'ditsy', 'p1', 'p2', 'p3', 'p31m', 'p3m1', 'p4', 'p4g'],
  ...['p4m', 'p6', 'p6m', 'pg', 'pgg', 'plaid', 'pm', 'pmg', 'pmm', 'regatta', 'tartan', 'ticking'],
];

describe.each(prints)('the print %s', {tags: ['thorough']}, (name) => {
  it.each(garments)('is whole on the pieces of %s', async (garment) => {
    const cell = await printedCell(name, 'svg');
    expectWhole(
      await comparedSheet(await scattered(garment), cell, {paper: paper('a4'), render: drawnPages}),
    );
  });
});

describe.each(Object.entries(installed))('in %s', {tags: ['thorough']}, (_, render) => {
  it.each(garments.map((garment, k) => [garment, prints[4 * k] ?? ''] as const))(
    '%s is whole in %s',
    async (garment, name) => {
      for (const kind of ['svg', 'png'] as const) {
        const cell = await printedCell(name, kind);
        expectWhole(
          await comparedSheet(await scattered(garment), cell, {paper: paper('a4'), render}),
        );
      }
    },
  );
});
