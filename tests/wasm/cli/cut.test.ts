import {copyFileSync, mkdtempSync, readFileSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';

import {afterAll, beforeAll, describe, expect, it} from 'vitest';

import type {SheetMap} from '@/paper/sheet-map.js';
import {seamwise} from '../../support/cli/command-line.js';
import {readPdf} from '../../support/paper/pdf.js';
import {checks, twoStrips} from '../../support/garments/samples.js';

let folder = '';
const file = (name: string) => join(folder, name);
const square = '<svg viewBox="0 0 4 4"><rect width="4" height="4" fill="#eee"/></svg>';

beforeAll(async () => {
  folder = mkdtempSync(join(tmpdir(), 'seamwise-'));
  writeFileSync(file('strips.json'), JSON.stringify(twoStrips(40)));
  writeFileSync(file('checks.svg'), square);
  writeFileSync(file('checks.json'), JSON.stringify({...checks, image: 'checks.svg'}));
  const words = ['--print', file('checks.json'), '--out', file('result.json')];
  expect((await seamwise('align', file('strips.json'), ...words)).code).toBe(0);
});

afterAll(() => {
  rmSync(folder, {recursive: true});
});

const cut = (...words: string[]) =>
  seamwise('cut', file('result.json'), '--print', file('checks.json'), ...words);

describe('cut', () => {
  it('writes pieces as PDF with a map of it, the same bytes each time, and says one line', async () => {
    const words = ['--paper', 'letter', '--map', file('map.json'), '--allowance', '1.5'];
    const {code, out, err} = await cut('--pdf', file('cut.pdf'), ...words);
    expect({code, err}).toEqual({code: 0, err: ''});
    const bytes = readFileSync(file('cut.pdf'));
    const {pages} = readPdf(bytes);
    const map = JSON.parse(readFileSync(file('map.json'), 'utf8')) as SheetMap;
    expect(out).toMatch(
      /^\S+: 2 pieces on a sheet of [\d.]+ x [\d.]+ cm; \d+ pages? of .* Letter\n$/,
    );
    expect(out).toContain(`${pages.length} page`);
    expect(map.pages).toHaveLength(pages.length);
    expect(map.pieces.map(({name}) => name)).toEqual(['left', 'right']);
    for (const {cut: outline, sew, place, grain} of map.pieces) {
      const height = (line: typeof sew): number =>
        Math.max(...line.map(([, y]) => y)) - Math.min(...line.map(([, y]) => y));
      expect(height(outline) - height(sew)).toBeCloseTo(3, 1);
      expect(Math.abs(Math.cos(place.angle))).toBeCloseTo(1, 9);
      expect(grain).toHaveLength(2);
    }
    await cut('--pdf', file('again.pdf'), ...words.slice(0, 2), '--allowance', '1.5');
    expect(readFileSync(file('again.pdf')).equals(bytes)).toBe(true);
  });

  it('writes the same sheet for other programs', async () => {
    const {code} = await cut(
      '--svg',
      file('cut.svg'),
      '--dxf',
      file('cut.dxf'),
      '--plt',
      file('cut.plt'),
    );
    expect(code).toBe(0);
    expect(readFileSync(file('cut.svg'), 'utf8')).toMatch(/^<svg/);
    expect(readFileSync(file('cut.dxf'), 'utf8')).toMatch(/EOF\r?\n$/);
    expect(readFileSync(file('cut.plt'), 'utf8')).toMatch(/^IN;/);
  });

  it('writes several results as sizes of one DXF file, in inches and as ASTM', async () => {
    copyFileSync(file('result.json'), file('large.json'));
    const nest = (...words: string[]) =>
      cut(file('large.json'), '--dxf', file('nest.dxf'), '--dxf-style', 'astm', ...words);
    expect((await nest('--dxf-unit', 'in')).code).toBe(0);
    const {out} = await seamwise('import', file('nest.dxf'), '--json', '--size', 'large');
    expect(JSON.parse(out)).toMatchObject({
      ...{sizes: ['Result', 'Large'], size: 'Large', units: {used: 'in', from: 'file'}},
      pieces: [{name: 'left', cutLine: true}, {name: 'right'}],
    });
    const {out: said} = await nest('--pdf', file('nest.pdf'));
    expect(said).toMatch(/^2 sizes as layers on \d+ page/);
    const {code, err} = await nest('--svg', file('nest.svg'));
    expect(code).toBe(2);
    expect(err).toMatch(/one file by --dxf and --pdf alone; write --svg of one result at a time/);
  });

  it('leaves the print out to save ink', async () => {
    await cut('--pdf', file('full.pdf'));
    await cut('--pdf', file('lines.pdf'), '--ink', 'outline');
    const names = (name: string): string => readFileSync(file(name), 'latin1');
    expect(names('full.pdf')).toContain('/Name (Print)');
    expect(names('lines.pdf')).not.toContain('/Name (Print)');
  });

  it.each([
    [
      ['--paper', 'a9'],
      /^seamwise: there is no paper 'a9'; name one of a4, .*projector, or a size/,
    ],
    [['--ink', 'red'], /^seamwise: --ink is 'red', but must be one of full, pale, outline\.\n$/],
    [
      ['--date', 'today'],
      /^seamwise: --date is 'today', but must be a day, such as 2026-03-21\.\n$/,
    ],
    [['--date', '2026-13-41'], /--date is '2026-13-41'/],
    [
      ['--pdf', 'one', '--svg', 'one'],
      /^seamwise: --pdf and --svg name the same file; name two\.\n$/,
    ],
    [['--allowance', '99'], /from 0 to 10 cm/],
    [['--dxf-unit', 'in'], /^seamwise: --dxf-unit belongs to --dxf FILE, which is missing\.\n$/],
  ])('refuses %j in one sentence', async (words, sentence) => {
    const {code, out, err} = await cut(...words);
    expect({code, out}).toEqual({code: 2, out: ''});
    expect(err).toMatch(sentence);
  });

  it('takes the picture of pixels that a colourway names, where it cannot draw its image', async () => {
    const gradient = '<svg viewBox="0 0 4 4"><rect width="4" height="4" fill="url(#g)"/></svg>';
    writeFileSync(file('silk.svg'), gradient);
    const silk = {...checks, image: 'silk.svg'};
    writeFileSync(file('silk.json'), JSON.stringify(silk));
    const words = ['cut', file('result.json'), '--pdf', file('silk.pdf'), '--print'];
    const {code, err} = await seamwise(...words, file('silk.json'));
    expect(code).toBe(2);
    expect(err).toMatch(/^seamwise: silk\.svg is none of the pictures that PDF files hold/);
    const others = await seamwise(...words, file('silk.json'), '--dxf', file('silk.dxf'));
    expect(others.code).toBe(2);
    expect(readFileSync(file('silk.dxf'), 'utf8')).toMatch(/EOF\r?\n$/);
    const raster = JSON.stringify({
      ...silk,
      colourways: [
        {name: 'Day', image: 'silk.svg', raster: join(process.cwd(), 'public/prints/check.png')},
      ],
    });
    writeFileSync(file('raster.json'), raster);
    expect((await seamwise(...words, file('raster.json'))).code).toBe(0);
    expect(readFileSync(file('silk.pdf'), 'latin1')).toContain('/Subtype/Image');
  });
});
