import {describe, expect, it} from 'vitest';

import {tracedLoop} from '@/files/base/bezier.js';
import {readAnyDrawing} from '@/files/read-drawing.js';
import type {Drawing, DrawingOptions, DrawnPiece} from '@/model/garment/imported-drawing.js';
import {boxOf} from '@/model/geometry/polyline.js';

import {
  contentOf,
  pdfOf,
  tilesOf,
  wordsPage,
  type DrawnStroke,
  type Tiling,
} from '../../support/files/drawn-pdf.js';
import {
  english,
  extents,
  grown,
  openBodice,
  piecesIn,
  places,
  plainSheet,
  size,
  type PieceWords,
} from '../../support/files/paper-patterns.js';

const a4 = [210, 297] as const;
const letter = [215.9, 279.4] as const;

const read = (bytes: Uint8Array, options?: DrawingOptions): Promise<Drawing> =>
  readAnyDrawing(bytes, 'pattern.pdf', options);

const taken = ({pieces}: Drawing): DrawnPiece[] => pieces.filter(({doubt}) => doubt === undefined);

function extentOf({sewn}: DrawnPiece): readonly [number, number] {
  const {low, high} = boxOf(tracedLoop(sewn, 0.01));
  return [high[0] - low[0], high[1] - low[1]];
}

/** Expects all four pieces at their size, with grain and number. @param by share of growth */
function expectGarment(drawing: Drawing, by = 0, words: PieceWords = english): void {
  const pieces = taken(drawing);
  expect(pieces.map(({name}) => name).sort()).toEqual(
    [words.front, words.back, words.sleeve, words.pocket].map(([name]) => name).sort(),
  );
  for (const part of ['front', 'back', 'sleeve', 'pocket'] as const) {
    const piece = pieces.find(({name}) => name === words[part][0]);
    if (!piece) continue;
    const [width, height] = extentOf(piece);
    expect(Math.abs(width - (1 + by) * extents[part][0]), part).toBeLessThan(0.3);
    expect(Math.abs(height - (1 + by) * extents[part][1]), part).toBeLessThan(0.3);
    expect(piece.grain, part).toBeDefined();
    expect(piece.fold !== undefined, part).toBe(part === 'front' || part === 'back');
    const {asDrawn, mirrored} = piece.quantity;
    expect(asDrawn + mirrored, part).toBe(part === 'sleeve' ? 2 : 1);
  }
}

const letterNames = (row: number, column: number): string =>
  `${String.fromCharCode(65 + row)}${String(column + 1)}`;

const tiled = (more: Partial<Tiling> = {}): Tiling => ({
  ...{paper: a4, margin: 10, overlap: 10, hasBorder: true, names: letterNames},
  ...more,
});

describe('a PDF pattern by somebody else', () => {
  it('is read from one large page', async () => {
    const sheet = plainSheet();
    const bytes = pdfOf([{width: size[0], height: size[1], content: contentOf(sheet)}]);
    const drawing = await read(bytes);
    expectGarment(drawing);
    expect(drawing.unit).toMatchObject({unit: 'mm', because: 'measured', isSure: true});
  });

  it('has its sizes as layers', async () => {
    const sizes = ['36', '38', '40', '42', '44'];
    const strokes = sizes.flatMap((name, k) => piecesIn(0.02 * k, {layer: `Size ${name}`}));
    const layers = sizes.map((name) => `Size ${name}`);
    const bytes = pdfOf(tilesOf(plainSheet(english, strokes), tiled()), {layers});
    const middle = await read(bytes);
    expect(middle).toMatchObject({sizes, size: '40'});
    expectGarment(middle, 0.04);
    expectGarment(await read(bytes, {size: '44'}), 0.08);
    await expect(read(bytes, {size: '50'})).rejects.toThrow(
      "pattern.pdf has no size '50'; choose one of 36, 38, 40, 42, 44.",
    );
  });

  it('has its sizes as dashes, with a legend', async () => {
    const dashes = ['[] 0 d', '[8 3] 0 d', '[2 2] 0 d'].map((dash) => `0 G 0.5 w ${dash}`);
    const names = ['S', 'M', 'L'];
    const sheet = plainSheet(
      english,
      dashes.flatMap((style, k) => piecesIn(0.03 * k, {style})),
    );
    const legend = dashes.map((style, k) => ({
      style,
      outline: {
        start: [430, 800 - 10 * k] as const,
        steps: [[[460, 800 - 10 * k]]] as const,
        isOpen: true,
      },
    }));
    const labels = names.map((text, k) => ({at: [465, 798.5 - 10 * k] as const, text, size: 5}));
    const bytes = pdfOf([
      {
        ...{width: size[0], height: size[1]},
        content: contentOf({
          ...sheet,
          strokes: [...sheet.strokes, ...legend],
          labels: [...sheet.labels, ...labels],
        }),
      },
    ]);
    const drawing = await read(bytes, {size: 'L'});
    expect(drawing.sizes).toEqual(names);
    expectGarment(drawing, 0.06);
  });

  it('has sizes that share an edge drawn once', async () => {
    const colours = ['1 0 0 RG', '0 0.5 0 RG', '0 0 1 RG'].map((colour) => `${colour} 0.5 w`);
    // the fold is drawn with the largest size alone
    const strokes = colours.flatMap((style, k) =>
      piecesIn(0.04 * k, {style}).map((one, part) => {
        const place = part === 0 ? places.front : places.back;
        const isShared = part < 2 && k < 2;
        return isShared ? {...one, outline: grown(openBodice, 0.04 * k, place)} : one;
      }),
    );
    const bytes = pdfOf(tilesOf(plainSheet(english, strokes), tiled()));
    const drawing = await read(bytes, {size: '1'});
    expect(drawing.sizes).toEqual(['1', '2', '3']);
    expectGarment(drawing);
  });

  it('begins with instructions and ends with thanks', async () => {
    const tiles = tilesOf(plainSheet(), tiled({names: () => '', hasBorder: false}));
    const bytes = pdfOf([wordsPage(a4, 40), wordsPage(a4, 30), ...tiles, wordsPage(a4, 5)]);
    const drawing = await read(bytes);
    expectGarment(drawing);
    expect(drawing.pages).toMatchObject({columns: 4, rows: 4, others: [1, 2, 19]});
  });

  it('has tiles of 7.5 x 10 in among pages of letters', async () => {
    const tiles = tilesOf(plainSheet(), tiled({paper: [190.5, 254], margin: 0, overlap: 0}));
    const bytes = pdfOf([wordsPage(letter, 40), ...tiles]);
    const drawing = await read(bytes);
    expectGarment(drawing);
    expect(drawing.pages?.others).toEqual([1]);
  });

  it.each([
    [0, 0],
    [5, 0],
    [10, 10],
    [15, 20],
    [20, 6.35],
  ])('has a margin of %i mm and an overlap of %f mm', async (margin, overlap) => {
    const tiling = tiled({margin, overlap, names: () => '', hasBorder: false});
    const drawing = await read(pdfOf(tilesOf(plainSheet(), tiling)));
    expectGarment(drawing);
  });

  it.each([90, 270])('has pages stored at %i degrees', async (rotate) => {
    expectGarment(await read(pdfOf(tilesOf(plainSheet(), tiled({rotate})))));
  });

  it('is locked by its owner', async () => {
    const bytes = pdfOf(tilesOf(plainSheet(), tiled()), {lock: {user: ''}});
    expectGarment(await read(bytes));
  });

  it.each<[string, PieceWords]>([
    [
      'French',
      {
        front: ['Devant', 'coupez 1 au pli'],
        back: ['Dos', 'couper 1 fois au pli'],
        sleeve: ['Manche', 'coupez 2'],
        pocket: ['Poche', 'couper 1'],
      },
    ],
    [
      'German',
      {
        front: ['Vorderteil', '1x im Bruch zuschneiden'],
        back: ['Rückenteil', '1x im Stoffbruch zuschneiden'],
        sleeve: ['Ärmel', '2x gegengleich zuschneiden'],
        pocket: ['Tasche', '1x zuschneiden'],
      },
    ],
    [
      'Italian',
      {
        front: ['Davanti', 'tagliare 1 volta sulla piega'],
        back: ['Dietro', 'tagliare 1 in doppio'],
        sleeve: ['Manica', 'tagliare 2'],
        pocket: ['Tasca', 'tagliare 1'],
      },
    ],
    [
      'Spanish',
      {
        front: ['Delantero', 'cortar 1 al doblez'],
        back: ['Espalda', 'cortar 1 en el doblez'],
        sleeve: ['Manga', 'cortar 2'],
        pocket: ['Bolsillo', 'cortar 1'],
      },
    ],
  ])('has its words in %s', async (_, words) => {
    const drawing = await read(pdfOf(tilesOf(plainSheet(words), tiled())));
    expectGarment(drawing, 0, words);
  });
});

describe('the pages of a PDF', () => {
  const tiles = tilesOf(plainSheet(), tiled({names: () => '', hasBorder: false}));
  const bytes = pdfOf([wordsPage(a4, 40), ...tiles]);

  it('are put together as stated', async () => {
    const pages = tiles.map((_, k) => k + 2);
    const drawing = await read(bytes, {pages, grid: [4, 4], trimCm: 1, overlapCm: 1});
    expectGarment(drawing);
    expect(drawing.pages).toMatchObject({columns: 4, rows: 4, overlapCm: [1, 1]});
  });

  it('keep the overlap of their borders where no line crosses these', async () => {
    const boxes = (x: number, width: number): DrawnStroke[] =>
      [20, 80, 140, 200].map((y) => ({
        outline: {start: [x, y], steps: [[[x + width, y]], [[x + width, y + 50]], [[x, y + 50]]]},
      }));
    // the boxes on the right begin 20 mm from their page's side, at the heights of the others
    const strokes = [...boxes(20, 150), ...boxes(200, 140)];
    const sheet = {width: 370, height: 277, strokes, labels: []};
    const {pieces, pages} = await read(pdfOf(tilesOf(sheet, tiled())));
    expect(pages?.overlapCm?.[0]).toBeCloseTo(1);
    expect(pieces.map((piece) => Math.round(extentOf(piece)[0])).sort()).toEqual([
      ...[140, 140, 140, 140, 150, 150, 150, 150],
    ]);
  });

  it('are put together by their places', async () => {
    const places = tiles.map((_, k) => ({
      number: k + 2,
      cell: [k % 4, Math.floor(k / 4)] as const,
    }));
    const drawing = await read(bytes, {places: places.toReversed()});
    expectGarment(drawing);
    expect(drawing.pages).toMatchObject({columns: 4, rows: 4, overlapCm: [1, 1]});
  });

  it('may be left out and keep their place', async () => {
    const {pieces, pages} = await read(bytes, {without: [10]});
    expect(pages).toMatchObject({columns: 4, rows: 4, others: [1, 10]});
    expect(pieces.map(({name}) => name)).toContain('Pocket');
  });

  it('are reported where their lines do not meet', async () => {
    const drawing = await read(bytes, {
      grid: [4, 4],
      overlapCm: 0.4,
      trimCm: 1,
      pages: [2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15, 16, 17],
    }).catch((error: unknown) => error as Error);
    const said = drawing instanceof Error ? drawing.message : drawing.notes.join(' ');
    expect(said).toMatch(/do not meet|does not close/);
  });
});
