/** Motifs that cross borders of the print's cell are as complete as all others. */
import {readFileSync} from 'node:fs';

import {describe, expect, it} from 'vitest';

import {rendered, decoded, type Pixels} from '@samples/prints/raster.js';
import {draftedSheet} from '@/cutting/drafted-sheet.js';
import type {CutSheet} from '@/cutting/cut-sheet.js';
import {norm} from '@/model/geometry/vectors.js';
import type {Print} from '@/model/print/repeating-print.js';
import {imageCell} from '@/model/print/wallpaper.js';
import {cuttingPdf} from '@/paper/cutting-pdf.js';
import {paperOf} from '@/paper/papers.js';
import {readGarment} from 'seamwise/node';
import {sample} from '../../support/garments/samples.js';
import {isThorough} from '../../support/level.js';
import {laidRectangle, onPrintAt, sheetOf} from '../../support/paper/cut-sheets.js';
import {renderers} from '../../support/paper/renderers.js';
import {comparedPage, type Comparison} from '../../support/paper/whole-print.js';

const a4 = paperOf('a4') ?? {name: 'none', widthCm: 0};
const dpi = 300;
/** Resolution of the print as one picture. [pixels per cm] */
const fine = 300;
const folder = new URL('../../../public/prints/', import.meta.url);
const printNamed = (name: string): Print =>
  JSON.parse(readFileSync(new URL(`${name}.json`, folder), 'utf8')) as Print;
const svgOf = (name: string): string => readFileSync(new URL(`${name}.svg`, folder), 'utf8');
const pngOf = (name: string): Buffer => readFileSync(new URL(`${name}.png`, folder));

const sized = (print: Print): readonly [number, number] =>
  imageCell(print).map((side) => Math.round(norm(side) * fine)) as [number, number];

interface Tile {
  readonly tile: string;
  readonly pixels: Pixels;
  readonly grainCm: number;
}

const vector = async (name: string): Promise<Tile> => ({
  ...{tile: svgOf(name), grainCm: 0},
  pixels: await rendered(svgOf(name), ...sized(printNamed(name)), '#fff'),
});

async function raster(name: string): Promise<Tile> {
  const pixels = await decoded(pngOf(name));
  const [a] = imageCell(printNamed(name));
  return {
    tile: `data:image/png;base64,${pngOf(name).toString('base64')}`,
    ...{pixels, grainCm: norm(a) / pixels.width},
  };
}

/** Compares pages of a sheet, evenly taken. */
async function compared(
  sheet: CutSheet,
  print: Print,
  {tile, pixels, grainCm}: Tile,
  {renderer = 'canvas', pages: count = 1} = {},
): Promise<Comparison> {
  const bare = {...sheet, pieces: sheet.pieces.map((piece) => ({...piece, marks: []}))};
  const [full, blank] = await Promise.all(
    (['full', 'outline'] as const).map((ink) => cuttingPdf(bare, {...print, tile}, {paper: a4, ink})),
  );
  if (!full || !blank) throw new Error('no file');
  const all = full.map.pages.length;
  const chosen = Array.from({length: Math.min(count, all)}, (_, k) =>
    Math.floor(((k + 0.5) * all) / Math.min(count, all)),
  );
  const render = renderers[renderer];
  if (!render) throw new Error(renderer);
  const [drawn, empty] = [await render(full.bytes, chosen, dpi), await render(blank.bytes, chosen, dpi)];
  const found = chosen.map((page, k) => {
    const [one, other] = [drawn[k], empty[k]];
    if (!one || !other) throw new Error('no page');
    const low = full.map.pages[page]?.sheet ?? [0, 0];
    return comparedPage({
      ...{page: one, blank: other, dpi, low, pieces: bare.pieces, print, tile: pixels, grainCm},
    });
  });
  const sum = (part: 'near' | 'elsewhere') => ({
    pixels: found.reduce((total, one) => total + one[part].pixels, 0),
    wrong: found.reduce((total, one) => total + one[part].wrong, 0),
    off: found.reduce((total, one) => total + one[part].off, 0),
  });
  return {near: sum('near'), elsewhere: sum('elsewhere'), places: found.flatMap(({places}) => places)};
}

const piece = (angle: number): CutSheet =>
  sheetOf(17, 25, [laidRectangle(17, 25, onPrintAt(angle, [3.1, 1.7]))]);

const share = ({pixels, wrong}: Comparison['near']): number => wrong / pixels;

/** Shares of pixels below this are noise of single pixels. */
const noise = 2e-4;

const expectWhole = ({near, elsewhere}: Comparison): void => {
  expect(near.pixels).toBeGreaterThan(1000);
  expect(share(near)).toBeLessThanOrEqual(share(elsewhere) + noise);
};

describe('a motif on the border of the cell', () => {
  it.each([0, 0.3])('is whole in vector prints turned by %s', async (angle) => {
    expectWhole(await compared(piece(angle), printNamed('cm'), await vector('cm')));
  });

  it.each([0, 0.3])('is whole in raster prints turned by %s', async (angle) => {
    expectWhole(await compared(piece(angle), printNamed('cm'), await raster('cm')));
  });
});
