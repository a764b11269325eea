/** Files opened and saved on the page. */
import {execFile} from 'node:child_process';
import {mkdtemp, readFile, rm} from 'node:fs/promises';
import {tmpdir} from 'node:os';
import {join} from 'node:path';
import {promisify} from 'node:util';

import type {Page} from 'playwright-core';
import type {SolveResult} from 'seamwise/node';
import {expect, it, vi} from 'vitest';

import {sampleOf} from '../../support/level.js';
import {designOf} from '../../support/page/design.js';
import {choose, hand, jsonFile, squares, type HandedFile} from '../../support/page/files.js';
import {bytesOf} from '../../support/page/browser.js';
import {button, saved, savedCut, showSample, solved, usePage} from '../../support/page/page.js';
import {printRadio} from '../../support/page/prints.js';

vi.setConfig({testTimeout: 180_000}); // a busy machine is slow at everything

const openPage = usePage();

/** A small page that does not solve; these tests need no answer. */
const quietPage = async (): Promise<Page> => {
  const page = await openPage({viewport: {width: 640, height: 480}});
  await page.getByRole('switch', {name: 'Match after each change'}).press('Space');
  return page;
};

const garmentShown = (page: Page, name: string): Promise<unknown> =>
  expect.poll(async () => (await designOf(page)).garment.name, {timeout: 20_000}).toBe(name);

/** The solver's answer without its times. */
function answerIn(result: string): string {
  const {design, ...answer} = JSON.parse(result) as SolveResult & {design: unknown};
  expect(design).toBeTruthy();
  return JSON.stringify(answer).replace(/"milliseconds":\{[^}]*\}/, '');
}

it('opens a garment that is chosen, dropped or pasted', {tags: ['thorough']}, async () => {
  const page = await openPage();
  await choose(page, 'My pattern', jsonFile('chosen.json', squares(40)));
  await garmentShown(page, 'chosen.json');
  await hand(page, 'drop', jsonFile('dropped.json', squares(50)));
  await garmentShown(page, 'dropped.json');
  await hand(page, 'paste', jsonFile('pasted.json', squares(60)));
  await garmentShown(page, 'pasted.json');
  await solved(page);
  const table = page.getByRole('table', {name: 'Pieces', exact: true});
  await table.getByRole('row', {name: /left/i}).waitFor();
  await table.getByRole('row', {name: /right/i}).waitFor();
});

it('opens a saved project to the same design', {tags: ['thorough']}, async () => {
  const page = await quietPage();
  await choose(page, 'My pattern', jsonFile('squares.json', squares(40)));
  await garmentShown(page, 'squares.json');
  await printRadio(page, 'pgg').click();
  const before = await designOf(page);
  expect(before.print.group).toBe('pgg');
  const project = await saved(page, 'Save project');
  const other = await quietPage();
  await hand(other, 'drop', jsonFile('squares.seamwise.json', project));
  await garmentShown(other, 'squares.json');
  expect(await designOf(other)).toEqual(before);
});

it(
  'opens a saved result to its design, which solves to the same result',
  {tags: ['thorough']},
  async () => {
    const page = await openPage();
    await solved(page);
    await showSample(page, 'tee');
    await button(page, 'Accept all symmetries').click();
    await solved(page);
    const design = await designOf(page);
    const result = await saved(page, 'Save result');
    const other = await openPage();
    await solved(other);
    await hand(other, 'drop', jsonFile('tee.result.json', result));
    await garmentShown(other, design.garment.name);
    await solved(other);
    expect(await designOf(other)).toEqual(design);
    expect(answerIn(await saved(other, 'Save result')) === answerIn(result)).toBe(true);
  },
);

it(
  'opens the result of a command line to the same garment, print and symmetries',
  {tags: ['thorough']},
  async () => {
    const folder = await mkdtemp(join(tmpdir(), 'seamwise-'));
    const out = join(folder, 'skirt.result.json');
    const files = ['public/garments/six-gore-skirt-m.json', '--print', 'public/prints/pgg.json'];
    await promisify(execFile)('node', ['dist/cli/main.js', 'align', ...files, '--out', out]);
    const content = await readFile(out, 'utf8');
    await rm(folder, {recursive: true});
    const page = await openPage();
    await choose(page, 'My pattern', {
      name: 'skirt.result.json',
      mimeType: 'application/json',
      content,
    });
    await garmentShown(page, 'six-gore-skirt-m.json');
    await solved(page);
    const {print} = await designOf(page);
    expect(print).toMatchObject({title: 'Parquet', group: 'pgg'});
    expect(print.image).toMatch(/^data:image\/svg/);
    const [before, after] = [content, await saved(page, 'Save result')].map(
      (text) => JSON.parse(text) as SolveResult,
    );
    expect(after?.symmetries.map(({kind}) => kind)).toEqual(
      before?.symmetries.map(({kind}) => kind),
    );
    expect(after?.metrics.fit).toBeLessThan(1.1 * (before?.metrics.fit ?? 0));
  },
);

it('opens a print file, and a picture as a print', async () => {
  const page = await quietPage();
  const print = {title: 'Mine', group: 'pmm', w1: [6, 0], w2: [0, 8]};
  await choose(page, 'My fabric', jsonFile('mine.json', print));
  await page.getByText('Your own: Mine').waitFor();
  expect((await designOf(page)).print).toMatchObject({group: 'pmm', size: {width: 6, height: 8}});
  const png = await readFile(new URL('../../../public/prints/pgg.png', import.meta.url));
  const [chooser] = await Promise.all([
    page.waitForEvent('filechooser'),
    button(page, 'My fabric').click(),
  ]);
  await chooser.setFiles({name: 'feet.png', mimeType: 'image/png', buffer: png});
  await expect
    .poll(async () => (await designOf(page)).print.image, {timeout: 20_000})
    .toBe(`data:image/png;base64,${png.toString('base64')}`);
});

it(
  'says in one sentence why a file cannot be opened, and leaves everything as it is',
  {tags: ['thorough']},
  async () => {
    const page = await quietPage();
    const before = await designOf(page);
    const open = squares(40) as {pattern: {panels: {left: {edges: object[]}}}};
    open.pattern.panels.left.edges.pop();
    const stranger = squares(40) as {pattern: {stitches: {panel: string}[][]}};
    const [[, end]] = stranger.pattern.stitches as [[unknown, {panel: string}]];
    end.panel = 'sleeve';
    const cases: readonly (readonly [HandedFile, RegExp])[] = [
      [jsonFile('words.json', 'once upon a time'), /pattern/],
      [jsonFile('list.json', {milk: 2, eggs: 6}), /garment/],
      [jsonFile('open.json', open), /left.*(open|closed)/],
      [jsonFile('stranger.json', stranger), /sleeve/],
      [jsonFile('future.json', {format: 'seamwise-project/9', design: {}}), /newer Seamwise/],
      [jsonFile('damaged.json', {format: 'seamwise-project/1', design: {}}), /damaged/],
      [jsonFile('bare.json', {format: 'seamwise-result/1', pieces: []}), /without its pattern/],
      [{name: 'noise.png', mimeType: 'image/png', content: 'noise'}, /cannot be read as a picture/],
    ];
    for (const [file, complaint] of cases) {
      await hand(page, 'drop', file);
      const alert = page.getByRole('alert').filter({hasText: file.name});
      await alert.waitFor();
      const said = (await alert.textContent())?.trim() ?? '';
      expect(said).toMatch(complaint);
      expect(said.match(/[.!?](?=\s|$)/g), said).toEqual(['.']);
      expect(await designOf(page)).toEqual(before);
    }
    await button(page, 'Dismiss').click();
    await expect.poll(() => page.getByRole('alert').count()).toBe(0);
  },
);

it(
  'knows a file by its first bytes, whatever it is called and whether or not a type is given',
  {tags: ['thorough']},
  async () => {
    const page = await quietPage();
    const before = await designOf(page);
    const cases: readonly (readonly [name: string, content: string, said: string])[] = [
      ['sheet.pdf', '%PDF-1.7 and so on', 'damaged or incomplete; export it again.'],
      ['shirt.json', '%PDF-1.7 and so on', 'damaged or incomplete; export it again.'],
      ['scan', 'II*\0\x08\0\0\0', 'a TIFF picture, which cannot be a print'],
    ];
    for (const [name, content, said] of cases) {
      await hand(page, 'drop', {name, mimeType: '', content});
      await page
        .getByRole('alert')
        .filter({hasText: `${name} is ${said}`})
        .waitFor();
      expect(await designOf(page)).toEqual(before);
    }
  },
);

it('offers to sew when a file has no seams', {tags: ['thorough']}, async () => {
  const page = await openPage();
  const garment = squares(40) as {pattern: {stitches: unknown[]}};
  garment.pattern.stitches = [];
  await choose(page, 'My pattern', jsonFile('loose.json', garment));
  await solved(page);
  await page.getByRole('button', {name: 'Suggest seams', pressed: true}).waitFor();
  await page.getByText('No seams yet').first().waitFor();
});

it('asks about the unit of a garment that fits nobody', {tags: ['thorough']}, async () => {
  const page = await openPage();
  await choose(page, 'My pattern', jsonFile('small.json', squares(6)));
  await page.getByText('Is the longest piece really 6 cm long?').waitFor();
  await button(page, 'No, the file is in inches').click();
  await page.getByText('Is the tallest piece').waitFor({state: 'detached'});
  await solved(page);
  const {pieces} = JSON.parse(await saved(page, 'Save result')) as SolveResult;
  expect(Math.max(...(pieces[0]?.rest ?? []).map(([, y]) => y))).toBeCloseTo(15.24, 6);
});

it('opens what its address names, and saves it as a project that opens again', async () => {
  const page = await openPage({query: '?garment=garments/tee-s.json&print=prints/pgg.json'});
  await solved(page);
  const design = await designOf(page);
  expect(design.garment.name).toBe('tee-s.json');
  expect(design.print).toMatchObject({title: 'Parquet', group: 'pgg'});
  expect(design.print.image).toMatch(/^data:image\/svg/);
  const project = await saved(page, 'Save project');
  await showSample(page, 'apron');
  await hand(page, 'drop', jsonFile('tee.seamwise.json', project));
  await garmentShown(page, 'tee-s.json');
  expect(await designOf(page)).toEqual(design);
});

it(
  'refuses an address on another host, and shows a sample in its place',
  {tags: ['thorough']},
  async () => {
    const page = await openPage({query: '?garment=https://example.com/coat.json'});
    const alert = page.getByRole('alert');
    await alert.filter({hasText: 'https://example.com/coat.json is on another host'}).waitFor();
    expect((await designOf(page)).garment.name).toBe('asymmetric-dress-m.json');
  },
);

it.each(
  sampleOf(1, [
    ['nowhere.json', /^nowhere\.json cannot be read/],
    ['prints/pgg.json', /^pgg\.json .+[.]$/],
  ]),
)(
  'says why %s in its address is no garment, and shows a sample in its place',
  {tags: ['thorough']},
  async (file, why) => {
    const page = await openPage({query: `?garment=${file}`, maySay: /404/});
    const alert = page.getByRole('alert');
    await alert.waitFor();
    expect((await alert.textContent())?.trim()).toMatch(why);
    expect((await designOf(page)).garment.name).toBe('asymmetric-dress-m.json');
    await solved(page);
  },
);

it('gives the pieces to cut in millimetres, and a picture', {tags: ['thorough']}, async () => {
  const page = await openPage();
  await choose(page, 'My pattern', jsonFile('squares.json', squares(40)));
  await garmentShown(page, 'squares.json');
  await solved(page);
  const svg = await savedCut(page, 'SVG');
  const [, width] = /^<svg [^>]*\bwidth="([\d.]+)mm"/.exec(svg) ?? [];
  // the pieces are side by side, with an allowance of 1 cm around each
  expect(Number(width)).toBeGreaterThan(840);
  await button(page, 'Save …').click();
  const [download] = await Promise.all([
    page.waitForEvent('download'),
    button(page, 'Save picture').click(),
  ]);
  expect(download.suggestedFilename()).toBe('squares.png');
  const png = await bytesOf(download);
  expect(png.subarray(1, 4).toString()).toBe('PNG');
});

it.each(sampleOf(1, ['-1', '12', '']))(
  'refuses to cut with an allowance of "%s", and keeps what was typed',
  {tags: ['thorough']},
  async (typed) => {
    const page = await openPage();
    await choose(page, 'My pattern', jsonFile('squares.json', squares(40)));
    await garmentShown(page, 'squares.json');
    await solved(page);
    let downloads = 0;
    page.on('download', () => downloads++);
    await button(page, 'Cut pattern').click();
    const field = page.getByLabel('Seam allowance (cm)');
    await field.fill(typed);
    await page.getByRole('button', {name: 'Save PDF'}).click();
    await page.getByRole('alert').filter({hasText: 'Enter a number from 0 cm to 10 cm.'}).waitFor();
    await expect.poll(() => field.inputValue()).toBe(typed);
    await field.fill('2');
    const svg = await savedCut(page, 'SVG');
    expect(svg).toContain('2 cm');
    expect(downloads).toBe(1);
  },
);
