import {readdirSync, readFileSync} from 'node:fs';
import {join} from 'node:path';
import {fileURLToPath} from 'node:url';

import {readGarment} from 'seamwise/node';
import {describe, expect, it} from 'vitest';

import type {CutSheet, LaidPiece} from '@/cutting/cut-sheet.js';
import {draftedSheet} from '@/cutting/drafted-sheet.js';
import {tracedLoop} from '@/files/base/bezier.js';
import {nearestOn} from '@/model/geometry/nearest.js';
import {readAnyDrawing} from '@/files/read-drawing.js';
import {foldLines} from '@/model/garment/folds.js';
import type {Drawing, DrawnPiece} from '@/model/garment/imported-drawing.js';
import {boxOf} from '@/model/geometry/polyline.js';
import {distance, minus, plus, type Point} from '@/model/geometry/vectors.js';
import {cuttingPdf} from '@/paper/cutting-pdf.js';
import {paperOf} from '@/paper/papers.js';

import {sampleOf} from '../../support/level.js';
import {onPrintAt} from '../../support/paper/cut-sheets.js';

const folder = fileURLToPath(new URL('../../../public/garments', import.meta.url));
const garments = sampleOf(
  1,
  readdirSync(folder)
    .filter((name) => name.endsWith('-m.json'))
    .sort((a, b) => order(a) - order(b)),
);

/** The tee first, of few pieces and each kind of line; the shirt is read from A4 in each run. */
function order(name: string): number {
  return name.startsWith('tee') ? 0 : 1;
}

const print = {group: 'p4m', w1: [5, 0], w2: [0, 5]} as const;
const tile = '<svg viewBox="0 0 10 10"><rect x="1" y="1" width="4" height="4" fill="#a33"/></svg>';

const inMm = (points: readonly Point[]): Point[] => points.map(([x, y]) => [10 * x, 10 * y]);

/** The greatest distance between two closed lines. [mm] */
function deviation(a: readonly Point[], b: readonly Point[]): number {
  const off = (from: readonly Point[], to: readonly Point[]): number[] =>
    from.map((p) => nearestOn(to, p, true).off);
  return Math.max(...off(a, b), ...off(b, a));
}

async function comesBack(sheet: CutSheet, paper: string, ink: 'full' | 'outline'): Promise<void> {
  const found = paperOf(paper);
  if (!found) throw new Error(paper);
  const {bytes} = await cuttingPdf(sheet, {...print, tile}, {paper: found, ink});
  const drawing = await readAnyDrawing(bytes, 'own.pdf');
  const isProjected = paper === 'projector';
  expect(drawing.pieces.map(({doubt}) => doubt)).toEqual(sheet.pieces.map(() => undefined));
  expect(drawing.pieces.map(({name}) => name).sort()).toEqual(
    sheet.pieces.map(({label}) => label).sort(),
  );
  const shift = shiftOf(sheet, drawing, isProjected);
  for (const laid of sheet.pieces) {
    const piece = drawing.pieces.find(({name}) => name === laid.label);
    if (piece) expectSame(laid, piece, shift, isProjected);
  }
}

/** The place of the sheet's origin in the drawing. */
function shiftOf({pieces}: CutSheet, drawing: Drawing, isProjected: boolean): Point {
  const [laid] = pieces;
  const piece = drawing.pieces.find(({name}) => name === laid?.label);
  const line = inMm((isProjected ? laid?.cut : laid?.sewn)?.[0] ?? []);
  return minus(boxOf(tracedLoop(piece?.sewn ?? [], 0.01)).low, boxOf(line).low);
}

function expectSame(laid: LaidPiece, piece: DrawnPiece, shift: Point, isProjected: boolean): void {
  const moved = (points: readonly Point[]): Point[] => inMm(points).map((p) => plus(p, shift));
  const sewn = tracedLoop(piece.sewn, 0.01);
  const line = moved((isProjected ? laid.cut : laid.sewn)[0] ?? []);
  expect(deviation(line, sewn), laid.label).toBeLessThan(0.2);
  const total = piece.quantity.asDrawn + piece.quantity.mirrored;
  expect(total, laid.label).toBe(laid.quantity);
  const ends = moved(laid.grain);
  const [foot, head] = piece.grain ?? [];
  const offs = [foot, head].map((end) =>
    Math.min(...ends.map((one) => distance(one, end ?? [0, 0]))),
  );
  expect(Math.max(...offs), laid.label).toBeLessThan(0.2);
  if (isProjected) return;
  expect(deviation(moved(laid.cut[0] ?? []), tracedLoop(piece.cut ?? [], 0.01))).toBeLessThan(0.2);
  expect(piece.folds?.length ?? 0, laid.label).toBe(laid.folds.length);
  for (const fold of piece.folds ?? []) {
    const lines = laid.folds.flatMap((one) => foldLines(one).map(moved));
    for (const ends of foldLines(fold)) {
      const off = lines.map((line) => Math.max(...ends.map((p) => nearestOn(line, p, false).off)));
      expect(Math.min(...off), laid.label).toBeLessThan(0.2);
    }
  }
  const cutInto = laid.notches.filter(({depthCm}) => depthCm > 0);
  expect(piece.notches, laid.label).toHaveLength(cutInto.length);
  for (const at of moved(cutInto.map((notch) => notch.at))) {
    const off = Math.min(...piece.notches.map((notch) => distance(notch.at, at)));
    expect(off, laid.label).toBeLessThan(0.25);
  }
}

const sheetOf = async (name: string): Promise<CutSheet> =>
  draftedSheet(await readGarment(readFileSync(join(folder, name), 'utf8')), {
    ...{allowanceCm: 1, hemCm: 3, units: 'cm'},
  });

describe.each(garments)('the cutting sheet of %s comes back as the same pieces', (name) => {
  const sheet = sheetOf(name);

  // the shirt is read from A4 below, and the projector's page with the print
  it.each(sampleOf(1, ['a0', 'a4', 'letter', 'projector']))('from %s', async (paper) => {
    await comesBack(await sheet, paper, 'outline');
  });

  it.each(['a4', 'projector'])('from %s with its print', async (paper) => {
    const {pieces, ...rest} = await sheet;
    const printed = pieces.map((piece) => ({...piece, ...onPrintAt(0.3, [1, 2])}));
    await comesBack({...rest, pieces: printed}, paper, 'full');
  });
});

/** The shirt has many pieces and holes in the grid of pages; the others have folds. */
it.each(['shirt', 'box-pleated-skirt', 'tucked-blouse'])(
  'the %s comes back from A4, with its folds',
  async (name) => {
    await comesBack(await sheetOf(`${name}-m.json`), 'a4', 'outline');
  },
);
