/** Drawings of other programs, from the file to the garment. */
import {readFile} from 'node:fs/promises';

import type {Locator, Page} from 'playwright-core';
import {readGarment} from 'seamwise/node';
import {describe, expect, it, vi} from 'vitest';

import {barriers} from '../../support/page/barriers.js';
import {designOf} from '../../support/page/design.js';
import {choose, hand, type HandedFile} from '../../support/page/files.js';
import {smallest, solved, usePage} from '../../support/page/page.js';
import {pdfOf, tilesOf, wordsPage} from '../../support/files/drawn-pdf.js';
import {english, piecesIn, plainSheet} from '../../support/files/paper-patterns.js';
import {plainDxf, type PlainPiece} from '../../support/files/plain-dxf.js';
import {sampleOf} from '../../support/level.js';
import {caughtUp} from '../../support/page/waiting.js';

vi.setConfig({testTimeout: 180_000}); // a busy machine is slow at everything

const openPage = usePage();

/** Corners of a sample's pieces. @param units  drawing units in a centimetre */
async function samplePieces(units = 10): Promise<readonly PlainPiece[]> {
  const text = await readFile('public/garments/tee-m.json', 'utf8');
  const {pieces} = await readGarment(text);
  return pieces.map(({name, outline}) => ({
    name,
    outline: outline.map(({points: [[x, y]]}) => [units * x, units * y] as const),
  }));
}

const dxf = (content: string, name = 'tee.dxf'): HandedFile => ({name, mimeType: '', content});

const sheet = (page: Page): Locator => page.locator('sw-import-sheet').getByRole('dialog');

async function offered(page: Page, file: HandedFile): Promise<Locator> {
  await hand(page, 'drop', file);
  await sheet(page).getByRole('button', {name: 'Open', exact: true}).waitFor();
  return sheet(page);
}

async function quietPage(options: Parameters<typeof openPage>[0] = {}): Promise<Page> {
  const page = await openPage({query: smallest, ...options});
  await solved(page);
  return page;
}

/** A tiled pattern in three sizes after a page of words; all of its bytes are ASCII. */
function tiledPdf(): HandedFile {
  const layers = ['36', '38', '40'].map((size) => `Size ${size}`);
  const strokes = layers.flatMap((layer, k) => piecesIn(0.03 * k, {layer}));
  const paper = [210, 297] as const;
  const tiles = tilesOf(plainSheet(english, strokes), {paper, margin: 10, overlap: 10});
  const bytes = pdfOf([wordsPage(paper, 40), ...tiles], {layers});
  return {name: 'dress.pdf', mimeType: 'application/pdf', content: Buffer.from(bytes).toString()};
}

it('puts the pages of a PDF together, and anew as its user corrects it', async () => {
  const page = await quietPage();
  const dialog = await offered(page, tiledPdf());
  await dialog.getByText('4 of 4 pieces').waitFor();
  await dialog.getByText('26.8 cm × 41.2 cm, half, on the fold').first().waitFor();
  await dialog.getByText('Left out: 1', {exact: true}).waitFor();
  await dialog.getByLabel('Size').selectOption('40');
  await dialog.getByText('27.6 cm × 42.4 cm, half, on the fold').first().waitFor();
  // two columns put wrong pages beside each other
  const columns = dialog.getByLabel('Columns');
  await columns.fill('2');
  await columns.press('Tab');
  await dialog
    .getByText(/Pages \d+ and \d+ do not meet/)
    .first()
    .waitFor();
  await columns.fill('4');
  await columns.press('Tab');
  await dialog.getByText('27.6 cm × 42.4 cm, half, on the fold').first().waitFor();
  // and so do pages that change places
  const [one, other] = [2, 6].map((number) =>
    dialog.locator('.page').filter({hasText: `Page ${String(number)}:`}),
  );
  await one?.dragTo(other ?? one);
  await dialog
    .getByText(/Pages \d+ and \d+ do not meet/)
    .first()
    .waitFor();
  await one?.dragTo(other ?? one);
  await dialog.getByText('27.6 cm × 42.4 cm, half, on the fold').first().waitFor();
  const scale = dialog.getByLabel('Scale 1 : n');
  await scale.fill('2');
  await scale.press('Tab');
  await dialog.getByText('55.1 cm × 84.8 cm, half, on the fold').first().waitFor();
  await scale.fill('1');
  await scale.press('Tab');
  await dialog.getByText('27.6 cm × 42.4 cm, half, on the fold').first().waitFor();
  await dialog.getByLabel('Seam allowance (cm)').fill('1');
  await dialog.getByLabel('Seam allowance (cm)').press('Tab');
  await dialog.getByText('The outer line is the cut line').waitFor();
  await dialog.getByRole('button', {name: 'Open', exact: true}).click();
  await dialog.waitFor({state: 'detached'});
  const {garment} = await designOf(page);
  expect(JSON.stringify(garment)).toContain('Pocket');
});

it(
  'shows the pieces of a DXF with the unit that fits, and leaves all as it is when that is cancelled',
  {tags: ['thorough']},
  async () => {
    const page = await quietPage();
    const before = await designOf(page);
    const pieces = await samplePieces();
    const dialog = await offered(page, dxf(plainDxf(pieces)));
    await dialog
      .getByText(/Largest piece 6\d(\.\d)? cm, unit mm, guessed from the size\./)
      .waitFor();
    await dialog.getByRole('img', {name: 'Ruler, 20 cm'}).waitFor();
    await dialog.getByText('4 of 4 pieces').waitFor();
    for (const name of ['Front', 'Back', 'Sleeve left', 'Sleeve right'])
      await expect
        .poll(() => dialog.getByRole('checkbox', {name, exact: true}).isChecked(), {message: name})
        .toBe(true);
    // previews are to scale
    const widths = await dialog
      .locator('li svg')
      .evaluateAll((all) => all.map((one) => one.getBoundingClientRect().width));
    expect((widths[2] ?? 0) / (widths[0] ?? 1)).toBeCloseTo(35 / 56, 1);
    await page.keyboard.press('Escape');
    await dialog.waitFor({state: 'detached'});
    expect(await designOf(page)).toEqual(before);
  },
);

it('opens what is chosen of a DXF as a project of its own, ready to be sewn', async () => {
  const page = await quietPage();
  const pieces = await samplePieces();
  await choose(page, 'My pattern', dxf(plainDxf(pieces, {words: ['Style Name: Summer tee']})));
  const dialog = sheet(page);
  await dialog.getByRole('checkbox', {name: 'Sleeve right'}).uncheck();
  await dialog.getByLabel('Copies of Sleeve left').selectOption('Cut a pair');
  await dialog.getByText('3 of 4 pieces').waitFor();
  await dialog.getByRole('button', {name: 'Open', exact: true}).click();
  await dialog.waitFor({state: 'detached'});
  await page.waitForFunction(() => document.title.startsWith('Summer tee'));
  const garment = await readGarment((await designOf(page)).garment.text);
  const [front] = garment.pieces;
  expect(garment.pieces.map(({name}) => name)).toEqual([
    ...['front', 'back', 'sleeve_left', 'sleeve_left 2'],
  ]);
  const drawn = (pieces[0]?.outline ?? []).map(([x]) => x / 10);
  const opened = (front?.outline ?? []).map(({points: [[x]]}) => x);
  const extent = (values: readonly number[]): number => Math.max(...values) - Math.min(...values);
  expect(extent(opened)).toBeCloseTo(extent(drawn), 6);
  expect(garment.symmetries).toContainEqual({
    ...{kind: 'pair', pieces: ['sleeve_left', 'sleeve_left 2']},
  });
  await page.getByRole('button', {name: 'Sew', exact: true, pressed: true}).waitFor();
});

it('takes another unit than it guessed, from who knows better', {tags: ['thorough']}, async () => {
  const page = await quietPage();
  const pieces = await samplePieces(1);
  const dialog = await offered(page, dxf(plainDxf(pieces)));
  await dialog.getByText('unit cm, guessed from the size.').waitFor();
  await dialog.getByRole('button', {name: /^in /}).click();
  await dialog.getByText('unit in, chosen.').waitFor();
  await dialog.getByRole('button', {name: 'Open', exact: true}).click();
  await dialog.waitFor({state: 'detached'});
  const [front] = (await readGarment((await designOf(page)).garment.text)).pieces;
  const extent = (values: readonly number[]): number => Math.max(...values) - Math.min(...values);
  const opened = (front?.outline ?? []).map(({points: [[x]]}) => x);
  const drawn = (pieces[0]?.outline ?? []).map(([x]) => x);
  expect(extent(opened)).toBeCloseTo(2.54 * extent(drawn), 6);
});

it(
  'says in one sentence why a drawing cannot be opened, and loses nothing',
  {tags: ['thorough']},
  async () => {
    const page = await quietPage();
    const before = await designOf(page);
    const pieces = await samplePieces();
    const cases: readonly (readonly [HandedFile, RegExp])[] = [
      [dxf('0\nSECTION\n2\nENTITIES\n0\nENDSEC\n0\nEOF\n', 'empty.dxf'), /^empty\.dxf /],
      [dxf('AutoCAD Binary DXF\r\n\x1a\0', 'binary.dxf'), /^binary\.dxf .*(binary|ASCII|text)/i],
      [dxf('once upon a time', 'tale.obj'), /^tale\.obj /],
    ];
    for (const [file, complaint] of cases) {
      await hand(page, 'drop', file);
      const alert = page.getByRole('alert').filter({hasText: file.name});
      await alert.waitFor();
      expect((await alert.textContent())?.trim()).toMatch(complaint);
      expect(await designOf(page)).toEqual(before);
    }
    // a piece that cannot be sewn is left out; taken all the same, its error appears in the dialog,
    // so that no choice is lost
    const [front, ...others] = pieces;
    const [a, b, ...rest] = front?.outline ?? [];
    const crossed = {name: 'front', outline: [b, a, ...rest].filter((p) => p !== undefined)};
    const dialog = await offered(page, dxf(plainDxf([crossed, ...others])));
    const odd = dialog.getByRole('checkbox', {name: /^front/i});
    await expect.poll(() => odd.isChecked()).toBe(false);
    await odd.check();
    await dialog.getByRole('checkbox', {name: 'Sleeve left'}).uncheck();
    await dialog.getByRole('button', {name: 'Open', exact: true}).click();
    await dialog.getByRole('alert').filter({hasText: 'front'}).waitFor();
    await expect
      .poll(() => dialog.getByRole('checkbox', {name: 'Sleeve left'}).isChecked())
      .toBe(false);
    expect(await designOf(page)).toEqual(before);
  },
);

const svg = `<svg xmlns="http://www.w3.org/2000/svg" width="400mm" height="400mm" viewBox="0 0 400 400">
<path d="M10 10H190V390H10Z" fill="none" stroke="#000"/><path d="M210 10H390V390H210Z" fill="none" stroke="#000"/></svg>`;

it(
  'says that a file is damaged or empty, and takes it for no picture',
  {tags: ['thorough']},
  async () => {
    const page = await quietPage();
    const alert = page.getByRole('alert');
    const svg = '<svg xmlns="http://www.w3.org/2000/svg" width="60cm" height="50cm"><path d="M0 0';
    await choose(page, 'My pattern', {name: 'cut.svg', mimeType: 'image/svg+xml', content: svg});
    await alert.filter({hasText: /cut\.svg is damaged near line 1/}).waitFor();
    await choose(page, 'My pattern', {name: 'no.dxf', mimeType: 'image/vnd.dxf', content: ''});
    await alert.filter({hasText: 'no.dxf is empty; export it again.'}).waitFor();
    await choose(page, 'My pattern', {name: 'a.pdf', mimeType: '', content: '%PDF-1.7\n'});
    await alert.filter({hasText: 'a.pdf is a damaged PDF; download or export it again.'}).waitFor();
  },
);

it('reads on until Escape', {tags: ['thorough']}, async () => {
  const page = await quietPage();
  const before = await designOf(page);
  let release = (): void => undefined;
  const held = new Promise<void>((resolve) => {
    release = resolve;
  });
  await page.route('**/drawing.worker*', async (route) => {
    await held;
    await route.continue().catch(() => undefined); // the request may have been cancelled
  });
  await hand(page, 'drop', dxf(plainDxf(await samplePieces())));
  const reading = page.getByText('Reading tee.dxf …');
  await reading.waitFor();
  await page.keyboard.press('Escape');
  await reading.waitFor({state: 'detached'});
  release();
  // a later drawing is shown, the cancelled one is not
  await offered(page, dxf(plainDxf((await samplePieces()).slice(0, 2)), 'later.dxf'));
  await sheet(page).getByText('2 of 2 pieces').waitFor();
  await page.keyboard.press('Escape');
  await sheet(page).waitFor({state: 'detached'});
  await caughtUp(page);
  await expect.poll(() => sheet(page).count()).toBe(0);
  expect(await designOf(page)).toEqual(before);
});

it(
  'asks whether an SVG that may be a pattern is one, and takes every other as a print',
  {tags: ['thorough']},
  async () => {
    const page = await quietPage();
    const before = await designOf(page);
    const file = {name: 'two.svg', mimeType: 'image/svg+xml', content: svg};
    await hand(page, 'drop', file);
    await sheet(page).getByRole('heading', {name: 'What is two.svg?'}).waitFor();
    await page.keyboard.press('Escape');
    await sheet(page).waitFor({state: 'detached'});
    expect(await designOf(page)).toEqual(before);

    await hand(page, 'drop', file);
    await sheet(page).getByRole('button', {name: 'A sewing pattern'}).click();
    await sheet(page).getByText('2 of 2 pieces').waitFor();
    await sheet(page).getByRole('button', {name: 'Cancel'}).click();

    await hand(page, 'drop', file);
    await sheet(page).getByRole('button', {name: 'A print'}).click();
    const image = async (): Promise<string> => (await designOf(page)).print.image;
    await expect.poll(image, {timeout: 60_000}).not.toBe(before.print.image);
    const two = await image();

    const dots = `<svg xmlns="http://www.w3.org/2000/svg" width="40" height="40"><circle cx="20" cy="20" r="9"/></svg>`;
    await hand(page, 'drop', {name: 'dots.svg', mimeType: 'image/svg+xml', content: dots});
    await expect.poll(image, {timeout: 60_000}).not.toBe(two);
  },
);

describe.each(sampleOf(1, ['dark', 'light'] as const))('in %s colours', (colorScheme) => {
  it('keeps nobody out, on a small screen either', {tags: ['thorough']}, async () => {
    for (const viewport of [
      {width: 1440, height: 900},
      {width: 390, height: 844},
    ]) {
      const page = await quietPage({colorScheme, viewport});
      const dialog = await offered(page, dxf(plainDxf(await samplePieces())));
      expect(await barriers(page)).toEqual([]);
      const overflow = await dialog.evaluate(
        ({scrollWidth, clientWidth}) => scrollWidth - clientWidth,
      );
      expect(overflow).toBe(0);
    }
  });
});
