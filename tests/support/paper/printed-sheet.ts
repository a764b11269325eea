/** Cutting sheets in sample prints, compared with the prints drawn as one picture. */
import {readFileSync} from 'node:fs';

import {decoded, rendered, type Pixels} from '@samples/prints/raster.js';
import type {CutSheet} from '@/cutting/cut-sheet.js';
import {norm, type Alignment} from '@/model/geometry/vectors.js';
import type {Print} from '@/model/print/repeating-print.js';
import {imageCell} from '@/model/print/wallpaper.js';
import {cuttingPdf} from '@/paper/cutting-pdf.js';
import type {Paper} from '@/paper/papers.js';
import type {PrintWithTile} from '@/picture/fabric.js';
import type {Renderer} from './renderers.js';
import {comparedPage, type Comparison} from './whole-print.js';

const dpi = 300;
/** Resolution of the print as one picture. [pixels per cm] */
const fine = 300;

const folder = new URL('../../../public/prints/', import.meta.url);
const fileOf = (name: string): Buffer => readFileSync(new URL(name, folder));

/** Plain green fabric: one cell larger than any sheet. */
const plain: {readonly print: PrintWithTile; readonly alignment: Alignment} = {
  print: {
    ...{group: 'p1', w1: [1000, 0], w2: [0, 1000]},
    tile: '<svg viewBox="0 0 1 1"><rect width="1" height="1" fill="#0f0"/></svg>',
  },
  alignment: {angle: 0, translation: [-500, -500]},
};

interface PrintedCell {
  readonly print: Print;
  /** The image of the cell in the PDF. */
  readonly tile: string;
  /** The same drawn as one picture. */
  readonly pixels: Pixels;
  /** The size of the pixels in the PDF; 0 for areas. [cm] */
  readonly grainCm: number;
}

/** The cell of a sample print, as SVG or as PNG. */
export async function printedCell(name: string, kind: 'svg' | 'png'): Promise<PrintedCell> {
  const print = JSON.parse(fileOf(`${name}.json`).toString()) as Print;
  const [width, height] = imageCell(print).map(norm) as [number, number];
  const file = fileOf(`${name}.${kind}`);
  if (kind === 'svg') {
    const [across, up] = [Math.round(width * fine), Math.round(height * fine)];
    const pixels = await rendered(file.toString(), across, up, '#fff');
    return {print, tile: file.toString(), pixels, grainCm: 0};
  }
  const pixels = await decoded(file);
  const tile = `data:image/png;base64,${file.toString('base64')}`;
  return {print, tile, pixels, grainCm: width / pixels.width};
}

/**
 * Compares pages of a sheet.
 * @param count number of pages, evenly taken
 */
export async function comparedSheet(
  sheet: CutSheet,
  {print, tile, pixels, grainCm}: PrintedCell,
  {paper, render, count = 1}: {readonly paper: Paper; readonly render: Renderer; count?: number},
): Promise<Comparison> {
  const pieces = sheet.pieces.map((piece) => ({...piece, marks: []}));
  const full = await cuttingPdf({...sheet, pieces}, {...print, tile}, {paper});
  const ofPlain = pieces.map((piece) => ({...piece, alignment: plain.alignment}));
  const blank = await cuttingPdf({...sheet, pieces: ofPlain}, plain.print, {paper});
  const all = full.map.pages.length;
  const some = Math.min(count, all);
  const chosen = Array.from({length: some}, (_, k) => Math.floor(((k + 0.5) * all) / some));
  const [drawn, empty] = [
    await render(full.bytes, chosen, dpi),
    await render(blank.bytes, chosen, dpi),
  ];
  const found = chosen.flatMap((number, k) => {
    const [page, other] = [drawn[k], empty[k]];
    const shown = full.map.pages[number];
    if (!page || !other || !shown) throw new Error(`no page ${number}`);
    const {sheet: low, window} = shown;
    return comparedPage({
      ...{page, plain: other, dpi, low, window, pieces, print, grainCm},
      tile: pixels,
    });
  });
  const sum = (part: 'near' | 'elsewhere') => ({
    pixels: found.reduce((total, one) => total + one[part].pixels, 0),
    wrong: found.reduce((total, one) => total + one[part].wrong, 0),
    off: found.reduce((total, one) => total + one[part].off, 0),
  });
  return {
    ...{near: sum('near'), elsewhere: sum('elsewhere')},
    places: found.flatMap(({places}) => places),
  };
}
