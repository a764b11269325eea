import {readdirSync, readFileSync} from 'node:fs';
import {join} from 'node:path';
import {fileURLToPath} from 'node:url';

import {describe, expect, it} from 'vitest';

import {onPiece, type Point} from '@/model/geometry/vectors.js';
import {imageCoordinates} from '@/model/print/image-coordinates.js';
import type {Print} from '@/model/print/repeating-print.js';
import {apply} from '@/model/geometry/plane-map.js';
import type {CutText} from '@/cutting/cut-sheet.js';
import {cuttingPdf, type CuttingPdf, type CuttingPdfOptions} from '@/paper/cutting-pdf.js';
import {paperOf} from '@/paper/papers.js';
import {laidRectangle, onPrintAt, sheetOf} from '../../support/paper/cut-sheets.js';
import {readPdf} from '../../support/paper/pdf.js';

const pointsPerCm = 72 / 2.54;
const slanted: Print = {group: 'p2', w1: [7.3, 0], w2: [2, 11.7]};
const dot = '<svg viewBox="0 0 10 10"><circle cx="5" cy="5" r="1" fill="#123"/></svg>';
const place = {angle: Math.PI, translation: [50, 40]} as const;
const printed = sheetOf(50, 40, [laidRectangle(50, 40, {place, ...onPrintAt(0.3, [1, 2])})]);

function written(
  paper: string,
  options: Partial<CuttingPdfOptions> = {},
  {sheet = printed, tile = dot} = {},
): Promise<CuttingPdf> {
  const found = paperOf(paper);
  if (!found) throw new Error(paper);
  return cuttingPdf(sheet, {...slanted, tile}, {paper: found, ...options});
}

/** Map from the sheet to the page by the page's first matrix. */
function onPage(content: string): (p: Point) => Point {
  const [a = NaN, , , d = NaN, e = NaN, f = NaN] = (/^q\n([-\d. ]+) cm/.exec(content)?.[1] ?? '')
    .split(' ')
    .map(Number);
  return ([x, y]) => [a * x + e, d * y + f];
}

describe('a PDF of pieces to cut', () => {
  it.each(['a4', 'letter', 'a0', '36in', 'projector'])('is well-formed, on %s', async (paper) => {
    const {bytes, layout} = await written(paper);
    const {pages, objects} = readPdf(bytes);
    expect(pages).toHaveLength(layout.pages.length);
    for (const {size} of pages) {
      expect(size[0]).toBeCloseTo(layout.widthCm * pointsPerCm, 3);
      expect(size[1]).toBeCloseTo(layout.heightCm * pointsPerCm, 3);
      expect(Math.max(...size)).toBeLessThanOrEqual(14_400);
    }
    for (const {stream = ''} of objects.values()) {
      expect(stream.match(/^q$|^q /gm)?.length).toBe(stream.match(/Q$/gm)?.length);
      expect(stream).not.toMatch(/NaN|undefined|Infinity|e[-+]\d/);
    }
  });

  it('is the same whenever it is written, but for a day', async () => {
    const [one, other] = [await written('a4'), await written('a4')];
    expect(Buffer.from(one.bytes).equals(other.bytes)).toBe(true);
    const {bytes} = await written('a4', {date: new Date('2026-03-21T10:00:00Z')});
    const text = Buffer.from(bytes).toString('latin1');
    expect(text).toContain('/CreationDate (D:20260321100000Z)');
    expect(readPdf(bytes).pages.every(({content}) => content.includes('2026-03-21'))).toBe(true);
  });

  it('shows a point of the sheet on each page where its map says', async () => {
    const {bytes, map} = await written('a4');
    readPdf(bytes).pages.forEach(({content}, k) => {
      const page = map.pages[k];
      const [x, y] = onPage(content)(page?.sheet ?? [0, 0]);
      expect(x).toBeCloseTo(0, 3);
      expect(y).toBeCloseTo(0, 3);
      const [right] = onPage(content)([(page?.sheet[0] ?? 0) + 10, 0]);
      expect(right).toBeCloseTo(10 * pointsPerCm, 3);
    });
  });

  it.each(['a4', 'a0', 'projector'])(
    'has squares of 5 cm and 2 in to measure, on %s',
    async (paper) => {
      const {bytes, map} = await written(paper);
      const {pages} = readPdf(bytes);
      expect(map.squares.map(({sideCm}) => sideCm)).toEqual([5, 5.08]);
      for (const {page, at, sideCm} of map.squares) {
        const [x = 0, y = 0] = [0, 1].map(
          (axis) => (map.pages[page]?.sheet[axis] ?? 0) + (at[axis] ?? 0),
        );
        const found = [...(pages[page]?.content ?? '').matchAll(/^([-\d. ]+) re$/gm)].map(
          ([, list = '']) => list.split(' ').map(Number),
        );
        expect(
          found.some(
            ([left = 0, low = 0, width, height]) =>
              Math.hypot(left - x, low - y) < 1e-3 && width === sideCm && height === sideCm,
          ),
        ).toBe(true);
      }
    },
  );

  it('lays every cell where the print has one', async () => {
    const {bytes} = await written('a0');
    const {content = ''} = readPdf(bytes).pages[0] ?? {};
    const [, matrix = '', cells = ''] =
      /W\* n\nq\n([-\d. ]+) cm\n((?:q 1 0 0 1 .* Do Q\n)+)/.exec(content) ?? [];
    const [a = 0, b = 0, c = 0, d = 0, e = 0, f = 0] = matrix.split(' ').map(Number);
    const piece = printed.pieces[0];
    const toImage = imageCoordinates(
      slanted,
      piece?.alignment ?? {angle: 0, translation: [0, 0]},
      [0, 0],
    );
    const places = [...cells.matchAll(/^q 1 0 0 1 (\S+) (\S+) cm/gm)];
    expect(places.length).toBeGreaterThan(20);
    for (const [, x, y] of places) {
      const [u, v] = [Number(x), Number(y)];
      const onSheet: Point = [a * u + c * v + e, b * u + d * v + f];
      // half a turn is its own inverse
      const image = apply(toImage, onPiece(place, onSheet));
      for (const share of image) expect(Math.abs(share - Math.round(share))).toBeLessThan(1e-4);
    }
  });

  it('has layers, and for a projector neither sewn lines nor frames, but a grid', async () => {
    const names = async (paper: string, ink: 'full' | 'outline') =>
      [
        ...Buffer.from((await written(paper, {ink})).bytes)
          .toString('latin1')
          .matchAll(/\/OCG\/Name \(([^)]*)\)/g),
      ].map(([, name]) => name);
    const common = ['Cut line', 'Sew line', 'Marks', 'Match points', 'Words', 'Page frame'];
    expect(await names('a4', 'full')).toEqual(['Print', ...common]);
    expect(await names('a4', 'outline')).toEqual(common);
    const wall = await names('projector', 'full');
    expect(wall).toContain('Grid');
    expect(wall).not.toContain('Sew line');
  });

  it('has letters of 7 points and more on paper, and of 15 mm on a projector', async () => {
    const small: CutText = {
      ...{kind: 'text', layer: 'words', at: [19, 20], lines: ['Small', 'words'], sizeMm: 3},
      hasPlate: true,
    };
    const sheet = sheetOf(50, 40, [{...laidRectangle(50, 40), marks: [small]}]);
    const leastOn = async (paper: string): Promise<number> => {
      const {pages} = readPdf((await written(paper, {}, {sheet})).bytes);
      const sizes = pages.flatMap(({content}) => [...content.matchAll(/^\/T\d (\S+) Tf$/gm)]);
      return Math.min(...sizes.map(([, size]) => 10 * Number(size)));
    };
    expect(await leastOn('a4')).toBeGreaterThan(2.47); // mm
    expect(await leastOn('projector')).toBeGreaterThanOrEqual(15);
  });

  it('draws cut lines over the white grounds of page frames', async () => {
    const red = '0.7843 0.0863 0.1137 RG';
    const pages = readPdf((await written('a4')).bytes).pages.filter(({content}) =>
      content.includes(red),
    );
    expect(pages.length).toBeGreaterThan(1);
    for (const {content} of pages) {
      expect(content.lastIndexOf(' re\nB\n')).toBeGreaterThan(0);
      expect(content.lastIndexOf(' re\nB\n')).toBeLessThan(content.indexOf(red));
    }
  });

  it('has a layer for each of several sizes, of which the first is shown', async () => {
    const sized = (size: string) => ({...sheetOf(50, 40), title: 'Apron', size});
    const print = {...slanted, tile: dot};
    const otherSizes = [{sheet: sized('L'), print}];
    const {bytes} = await written('a0', {otherSizes}, {sheet: sized('M')});
    const text = Buffer.from(bytes).toString('latin1');
    const refs = [...text.matchAll(/^(\d+) 0 obj\n<<\/Type\/OCG\/Name \(Size (\w)\)>>/gm)];
    expect(refs.map(([, , size]) => size)).toEqual(['M', 'L']);
    expect(text).toContain(`/OFF[${refs[1]?.[1] ?? ''} 0 R]`);
    const {content = ''} = readPdf(bytes).pages[0] ?? {};
    expect(content).toContain('(Apron, Sizes M, L)');
    expect(content).toMatch(/\/OC \/L1 BDC\n[^]*\[0\.8 0\.3\] 0 d/);
  });

  it('tints a pale print, and draws none as outlines', async () => {
    const tints = async (ink: 'full' | 'pale' | 'outline') =>
      readPdf((await written('a0', {ink})).bytes).pages.map(
        ({content}) => content.match(/\/G\d+ gs\n1 1 1 rg\n[^\n]* re\nf/g)?.length ?? 0,
      );
    const [full, pale, outline] = [
      await tints('full'),
      await tints('pale'),
      await tints('outline'),
    ];
    expect(full).toEqual(outline);
    expect(pale.reduce((sum, count) => sum + count, 0)).toBe(1);
  });

  it('adds a placing guide with the footer of all pages', async () => {
    const [plain, guided] = [
      await written('a4', {ink: 'outline'}),
      await written('a4', {ink: 'outline', guide: {units: 'inch'}}),
    ];
    const pages = readPdf(guided.bytes).pages;
    expect(pages).toHaveLength(plain.layout.pages.length + 1);
    expect(pages.at(-1)?.content).toMatch(/Motif \d.* in /);
    expect(pages[0]?.content).toContain(`of ${pages.length})`);
    expect(guided.map).toEqual(plain.map);
    const wall = await written('projector', {guide: {units: 'cm'}});
    expect(readPdf(wall.bytes).pages).toHaveLength(1);
  });

  it('embeds Latin, Greek and Cyrillic letters', async () => {
    const [piece = laidRectangle(1, 1)] = printed.pieces;
    const sheet = {...printed, heading: 'Юбка (Größe 38)', pieces: [{...piece, label: 'Środek'}]};
    const {bytes, notes} = await written('a4', {mark: 'NOT AS IT WAS SOLD'}, {sheet});
    const {content = ''} = readPdf(bytes).pages[0] ?? {};
    expect(content).toContain('(Юбка (Größe 38))');
    expect(content).toContain('(NOT AS IT WAS SOLD)');
    expect(notes).toEqual([]);
    const fonts = Buffer.from(bytes)
      .toString('latin1')
      .match(/\/FontFile2 /g);
    expect(fonts).toHaveLength(2); // regular and bold
  });

  it('outlines cells where there is no picture, and says what it cannot draw', async () => {
    const bare = await cuttingPdf(printed, slanted, {
      paper: {name: 'A0', widthCm: 84.1, heightCm: 118.9},
    });
    expect(readPdf(bare.bytes).pages).toHaveLength(1);
    const gradient = '<svg viewBox="0 0 1 1"><rect width="1" height="1" fill="url(#g)"/></svg>';
    await expect(written('a4', {}, {sheet: printed, tile: gradient})).rejects.toThrow(
      /save it as PNG/,
    );
  });
});

it('draws all prints of the project as areas, and none in pixels', async () => {
  const folder = fileURLToPath(new URL('../../../public/prints', import.meta.url));
  const {vectorTile} = await import('@/paper/vector-tile.js');
  const files = readdirSync(folder).filter((name) => /^[^-]+\.svg$/.test(name));
  expect(files.length).toBeGreaterThan(20);
  for (const name of files) {
    const groups = vectorTile(readFileSync(join(folder, name), 'utf8'), 10, 10) ?? [];
    expect(
      groups.reduce((sum, {leaves}) => sum + leaves.length, 0),
      name,
    ).toBeGreaterThan(1);
  }
});
