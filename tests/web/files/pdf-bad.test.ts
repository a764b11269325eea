import {describe, expect, it} from 'vitest';

import {readAnyDrawing} from '@/files/read-drawing.js';
import type {Drawing} from '@/model/garment/imported-drawing.js';

import {contentOf, pdfOf, tilesOf, wordsPage} from '../../support/files/drawn-pdf.js';
import {plainSheet, size} from '../../support/files/paper-patterns.js';

const read = (bytes: Uint8Array): Promise<Drawing> => readAnyDrawing(bytes, 'bad.pdf');

const a4 = [210, 297] as const;
const tiles = tilesOf(plainSheet(), {paper: a4, margin: 10, overlap: 10});
const good = pdfOf(tiles);

const textOf = (bytes: Uint8Array): string => Buffer.from(bytes).toString('latin1');
const bytesOf = (text: string): Uint8Array => Uint8Array.from(Buffer.from(text, 'latin1'));

describe('a PDF', () => {
  it('with a broken cross-reference table is read', async () => {
    const broken = bytesOf(textOf(good).replace(/startxref\n\d+/, 'startxref\n7'));
    expect((await read(broken)).pieces).toHaveLength(4);
  });

  it('that is cut off is read as far as it goes, or refused in one sentence', async () => {
    const half = bytesOf(textOf(good).slice(0, textOf(good).length >> 1));
    await expect(read(half)).rejects.toThrow(/^bad\.pdf [^\n]*[.]$/);
  });

  it('locked by a password is refused', async () => {
    await expect(read(pdfOf(tiles, {lock: {user: 'secret'}}))).rejects.toThrow(
      'bad.pdf is locked by a password; open it in a PDF viewer, and save it without one.',
    );
  });

  it('of words alone is refused', async () => {
    await expect(read(pdfOf([wordsPage(a4, 30)]))).rejects.toThrow(
      'bad.pdf shows no lines; choose the PDF of the pattern, and not that of its instructions.',
    );
  });

  it('of pictures alone is refused', async () => {
    const [width, height] = a4;
    const text = textOf(pdfOf([{width, height, content: 'q 180 0 0 250 10 10 cm /I Do Q'}]));
    const image = '/XObject<</I<</Subtype/Image/Width 2/Height 2>>>>';
    await expect(read(bytesOf(text.replace('/Font<<', `${image}/Font<<`)))).rejects.toThrow(
      'bad.pdf shows pictures alone, as scans do; only patterns drawn with lines can be read, so ask its maker for a PDF with lines.',
    );
  });

  it('of 300 pages is read up to a number of pages', async () => {
    const pages = [...tiles, ...Array.from({length: 284}, () => wordsPage(a4, 3))];
    const {pieces, notes} = await read(pdfOf(pages));
    expect(pieces).toHaveLength(4);
    expect(notes.join(' ')).toContain('The file has 300 pages, of which the first 200 are read');
  });

  it('of millions of points is refused', async () => {
    const wave = Array.from({length: 20_000}, (_, k) => `${k % 200} ${(k * 7) % 280} l`).join('\n');
    const content = `0 0 m\n${wave}\nS\n`.repeat(20);
    const [width, height] = a4;
    const pages = Array.from({length: 6}, () => ({width, height, content}));
    await expect(read(pdfOf(pages))).rejects.toThrow(
      /^bad\.pdf has more than 260,000 visible points up to page 1/,
    );
  });

  it('of states that are saved and never restored is refused', async () => {
    const [width, height] = a4;
    const content = 'q 1 0 0 1 0 0 cm\n'.repeat(200_000);
    await expect(read(pdfOf([{width, height, content}]))).rejects.toThrow(
      /^bad\.pdf has more than 2,000 nested groups up to page 1/,
    );
  });

  it('with a piece and tens of thousands of lines at one place is read', async () => {
    const [width, height] = a4;
    const rays = Array.from(
      {length: 40_000},
      (_, k) => `100 140 m ${100 + 90 * Math.cos(k)} ${140 + 90 * Math.sin(k)} l S`,
    ).join('\n');
    const {pieces} = await read(pdfOf([{width, height, content: `${rays}\n5 5 60 60 re S`}]));
    expect(pieces.map(({sewn}) => sewn.map(({start}) => start.map(Math.round)))).toContainEqual([
      [5, -292],
      [65, -292],
      [65, -232],
      [5, -232],
    ]);
  });

  it('of forms that draw each other millions of times is refused', async () => {
    const wave = Array.from({length: 200}, (_, k) => `${k} ${k % 7} l`).join('\n');
    const page = {width: 210, height: 297, content: '/Form0 Do'};
    const text = textOf(pdfOf([page])).replace('/Font<<', '/XObject<</Form0 101 0 R>>/Font<<');
    const forms = Array.from({length: 7}, (_, k) => {
      const draws = k < 6 ? '/Inner Do '.repeat(10) : `0 0 m ${wave} S`;
      const inner = `/Resources<</XObject<</Inner ${102 + k} 0 R>>>>`;
      const entries = `/Subtype/Form/BBox[0 0 300 300]${inner}/Length ${draws.length}`;
      return `${101 + k} 0 obj\n<<${entries}>>\nstream\n${draws}\nendstream\nendobj\n`;
    });
    const bytes = bytesOf(
      text.replace('xref\n', `${forms.join('')}xref\n`).replace(/startxref\n\d+/, 'startxref\n7'),
    );
    await expect(read(bytes)).rejects.toThrow(/^bad\.pdf has more than \S+ (?:\S+ )?points up to/);
  });

  it('of pages of letters drawn as outlines is read', async () => {
    const letter = Array.from(
      {length: 90},
      (_, k) => `${Math.cos(k / 14.4)} ${Math.sin(k / 14.4)} l`,
    );
    const letters = Array.from(
      {length: 2500},
      (_, k) =>
        `q 1 0 0 1 ${10 + 3 * (k % 60)} ${10 + 5 * Math.floor(k / 60)} cm 1 0 m ${letter.join(' ')} f Q`,
    ).join('\n');
    const [width, height] = a4;
    const outlined = Array.from({length: 2}, () => ({width, height, content: letters}));
    const {pieces, notes} = await read(pdfOf([...outlined, ...tiles]));
    expect(pieces).toHaveLength(4);
    expect(notes.join(' ')).toContain('filled marks from page 2 on are left out');
  });

  it('of thousands of lines of words is refused', async () => {
    const words = (page: number): string =>
      Array.from(
        {length: 12_000},
        (_, k) => `BT /F1 4 Tf ${k % 200} ${(k * 5 + page) % 290} Td (W) Tj ET`,
      ).join('\n');
    const pages = Array.from({length: 10}, (_, k) => ({
      width: 210,
      height: 297,
      content: words(k),
    }));
    await expect(read(pdfOf(pages))).rejects.toThrow(/^bad\.pdf has more than 100,000 texts/);
  });

  it('with neither pages nor objects is refused', async () => {
    await expect(read(bytesOf('%PDF-1.7\n%%EOF\n'))).rejects.toThrow(
      'bad.pdf is a damaged PDF; download or export it again.',
    );
  });

  it('runs no script and fetches nothing', async () => {
    const whole = {width: size[0], height: size[1], content: contentOf(plainSheet())};
    const text = textOf(pdfOf([whole])).replace(
      '/Type/Catalog',
      '/Type/Catalog/OpenAction<</S/JavaScript/JS(globalThis.wasRun = 1)>>',
    );
    expect((await read(bytesOf(text))).pieces).toHaveLength(4);
    expect('wasRun' in globalThis).toBe(false);
  });

  it('leaves the globals of its reader as they were', async () => {
    await read(good);
    expect(['window', 'DOMMatrix', 'Path2D'].filter((name) => name in globalThis)).toEqual([]);
  });
});
