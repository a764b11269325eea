/** What the page says and does when something under it breaks, or is not wanted. */
import type {Page, Worker} from 'playwright-core';
import {describe, expect, it} from 'vitest';

import {designOf} from '../support/page-design.js';
import {button, progress, showSample, solved, usePage} from '../support/page.js';

const openPage = usePage();

const says = (page: Page, words: RegExp): Promise<void> =>
  progress(page).filter({hasText: words}).waitFor({timeout: 60_000});

const group = (page: Page, name: string): Promise<void> =>
  page.getByRole('radio', {name: new RegExp(`^${name},`)}).click();

/** The solver at work on a garment that keeps it busy. */
async function busy(page: Page): Promise<Worker> {
  await solved(page);
  await showSample(page, 'patchwork-jacket');
  await group(page, 'pgg');
  await says(page, /^(Aligning|Shaping)/);
  const [worker] = page.workers();
  if (!worker) throw new Error('There is no solver.');
  return worker;
}

describe('a solver that breaks', () => {
  it.each([
    ['an error', 'setTimeout(() => { throw new Error("out of order"); })'],
    ['silence', 'self.close()'],
  ])('with %s is started again, and gives its answer', async (_, end) => {
    const page = await openPage({maySay: /out of order/});
    const worker = await busy(page);
    const notice = page.getByText('The solver broke and was started again; nothing is lost.');
    await Promise.all([
      notice.waitFor({timeout: 60_000}),
      // one that ends does not say that it has
      worker.evaluate(end).catch(() => undefined),
    ]);
    await solved(page);
    expect((await designOf(page)).print.group).toBe('pgg');
    await page.getByLabel('Fit', {exact: true}).waitFor();
  });
});

it('says so when the solver cannot be loaded, and solves once it can be', async () => {
  const page = await openPage({maySay: /404|wasm|^Aborted|ArrayBuffer instantiation/i});
  await solved(page);
  await page.route('**/*.wasm', (route) => route.fulfill({status: 404, body: 'gone'}));
  await page.reload();
  await says(page, /^Not aligned$/);
  const said = (await page.getByRole('alert').textContent())?.trim() ?? '';
  expect(said).toMatch(/^The solver could not be loaded.*\.$/);
  await page.unroute('**/*.wasm');
  await button(page, 'Align').click();
  await solved(page);
});

it('still has its tables where nothing can be drawn', async () => {
  const page = await openPage({maySay: /WebGL/});
  await page.addInitScript(() => {
    HTMLCanvasElement.prototype.getContext = () => null;
  });
  await page.reload();
  await page.getByText('This browser cannot draw the pattern: it has no WebGL 2.').waitFor();
  await solved(page);
  for (const name of ['Pieces', 'Seams']) {
    const rows = page.getByRole('table', {name, exact: true}).getByRole('row');
    expect(await rows.count()).toBeGreaterThan(5);
  }
});

it('says that what is shown is out of date once a solve is cancelled', async () => {
  const page = await openPage();
  await busy(page);
  await button(page, 'Cancel').click();
  await says(page, /^Cancelled/);
  await page.getByText('The picture is out of date').waitFor();
  expect(await button(page, 'Cancel').isDisabled()).toBe(true);
  await button(page, 'Align').click();
  await solved(page);
  expect(await page.getByText('The picture is out of date').count()).toBe(0);
});

it('waits for Align where nobody wants to solve with every change', async () => {
  const page = await openPage();
  await solved(page);
  await page.getByRole('switch', {name: 'Solve as I go'}).press('Space');
  await group(page, 'cmm');
  await says(page, /^Out of date/);
  await page.getByText('The picture is out of date').waitFor();
  expect(await button(page, 'Save result').isDisabled()).toBe(true);
  expect(await button(page, 'Cancel').isDisabled()).toBe(true);
  await button(page, 'Align').click();
  await solved(page);
  await page.getByRole('switch', {name: 'Solve as I go'}).press('Space');
  await group(page, 'pgg');
  await solved(page);
});
