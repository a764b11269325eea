/**
 * Tables of pieces and seams, linked with the pattern in both directions. Tested on a raglan shirt:
 * 8 pieces, 12 seams.
 */
import type {Locator, Page} from 'playwright-core';
import {expect, it} from 'vitest';

import type {Design} from '@/model/design/design.js';
import type {Target, Workbench} from '@/workbench/workbench.js';
import {designOf} from '../../support/page/design.js';
import {button, showSample, solved, usePage} from '../../support/page/page.js';

const openPage = usePage();

const table = (page: Page, name: 'Pieces' | 'Seams'): Locator =>
  page.getByRole('table', {name, exact: true});
/** Rows below the header. */
const rows = (page: Page, name: 'Pieces' | 'Seams'): Locator =>
  table(page, name).locator('tbody').getByRole('row');
const row = (page: Page, name: string): Locator =>
  page.getByRole('row').filter({has: page.getByRole('rowheader', {name: new RegExp(`^${name}`)})});

const selection = (page: Page, name: 'pointed' | 'selected'): Promise<Target | undefined> =>
  page.evaluate((property) => {
    const element = document.querySelector<HTMLElement & {workbench: Workbench}>('seamwise-page');
    return element?.workbench.selection[property];
  }, name);
const options = async (page: Page): Promise<Design['options']> => (await designOf(page)).options;

async function opened(): Promise<Page> {
  const page = await openPage();
  await showSample(page, 'raglan');
  await row(page, 'Centre back').waitFor();
  return page;
}

/** Numbers of a column after the first, from top to bottom. */
const column = async (page: Page, name: 'Pieces' | 'Seams', number: number): Promise<number[]> =>
  (await rows(page, name).locator(`td:nth-of-type(${number})`).allTextContents()).map(parseFloat);

const falling = (numbers: readonly number[]): number[] => [...numbers].sort((a, b) => b - a);

it('lists all pieces and all seams, the worst seam first', async () => {
  const page = await opened();
  await solved(page);
  await expect.poll(() => rows(page, 'Pieces').count()).toBe(8);
  await expect.poll(() => rows(page, 'Seams').count()).toBe(12);
  const after = table(page, 'Seams').getByRole('columnheader', {name: 'After'});
  await expect.poll(() => after.getAttribute('aria-sort')).toBe('descending');
  const mismatches = await column(page, 'Seams', 3);
  expect(mismatches).toEqual(falling(mismatches));
});

it(
  'sorts by a column, and the other way round when asked again',
  {tags: ['thorough']},
  async () => {
    const page = await opened();
    const seams = table(page, 'Seams');
    const header = seams.getByRole('columnheader', {name: 'Length'});
    await header.getByRole('button').click();
    const lengths = await column(page, 'Seams', 1);
    expect(lengths).toEqual(falling(lengths));
    await header.getByRole('button').click();
    await expect.poll(() => header.getAttribute('aria-sort')).toBe('ascending');
    expect(await column(page, 'Seams', 1)).toEqual(falling(lengths).reverse());
  },
);

it('selects in the picture what is clicked in a table', {tags: ['thorough']}, async () => {
  const page = await opened();
  const front = row(page, 'Front left');
  await front.getByRole('rowheader').click();
  await expect.poll(() => front.getAttribute('aria-selected')).toBe('true');
  expect(await selection(page, 'selected')).toMatchObject({kind: 'piece'});
});

it(
  'points in the picture at what the pointer is over in a table',
  {tags: ['thorough']},
  async () => {
    const page = await opened();
    await row(page, 'Centre back').getByRole('rowheader').hover();
    expect(await selection(page, 'pointed')).toMatchObject({kind: 'seam'});
    await page.getByRole('heading', {name: 'Seamwise'}).hover();
    expect(await selection(page, 'pointed')).toBeUndefined();
  },
);

it('walks the rows by keys', {tags: ['thorough']}, async () => {
  const page = await opened();
  await rows(page, 'Pieces').first().press('End');
  await page.keyboard.press('Enter');
  await expect.poll(() => rows(page, 'Pieces').last().getAttribute('aria-selected')).toBe('true');
  await page.keyboard.press('ArrowUp');
  await page.keyboard.press(' ');
  await expect.poll(() => rows(page, 'Pieces').nth(6).getAttribute('aria-selected')).toBe('true');
  await expect.poll(() => rows(page, 'Pieces').last().getAttribute('aria-selected')).toBe('false');
});

it('shows the row of what is selected in the picture', {tags: ['thorough']}, async () => {
  const page = await opened();
  await page.evaluate(() => {
    const element = document.querySelector<HTMLElement & {workbench: Workbench}>('seamwise-page');
    element?.workbench.selection.select({kind: 'seam', seam: 1, side: 'b'});
  });
  const centreBack = row(page, 'Centre back');
  await expect.poll(() => centreBack.getAttribute('aria-selected')).toBe('true');
  const box = await centreBack.boundingBox();
  expect(box?.y).toBeGreaterThan(0);
  expect(box && box.y + box.height).toBeLessThanOrEqual(900);
});

it('lets a seam match less, or not at all, as one step each', {tags: ['thorough']}, async () => {
  const page = await opened();
  const match = page.getByRole('combobox', {name: 'Match: Side seam, left'});
  await match.selectOption({label: 'Half'});
  expect(await options(page)).toMatchObject({weights: {2: 0.5}});
  await match.selectOption({label: "Don't match"});
  expect(await options(page)).toMatchObject({unmatched: [2]});
  await button(page, 'Undo').click();
  await expect.poll(() => match.inputValue()).toBe('half');
  await button(page, 'Undo').click();
  await expect.poll(() => match.inputValue()).toBe('full');
});

it('cuts a piece from plain cloth, or on a grain of its own', {tags: ['thorough']}, async () => {
  const page = await opened();
  await page.getByRole('checkbox', {name: 'Printed: Front left'}).click();
  await page.getByRole('combobox', {name: 'Grain: Back left'}).selectOption('bias');
  expect(await options(page)).toMatchObject({
    ...{plain: ['front_left'], grain: {pieces: {back_left: 'bias'}}},
  });
});

it('frees a piece that was pinned', {tags: ['thorough']}, async () => {
  const page = await opened();
  await page.evaluate(() => {
    const element = document.querySelector<HTMLElement & {workbench: Workbench}>('seamwise-page');
    const {workbench: bench} = element ?? {};
    if (!bench?.history.design) return;
    const pins = {front_left: {angle: 0, translation: [0, 0]}} as const;
    bench.history.change({options: {...bench.history.design.options, pins}});
  });
  await button(page, 'Free: Front left').click();
  expect((await options(page)).pins).toEqual({});
});

it('says that a garment without seams has nothing to match', {tags: ['thorough']}, async () => {
  const page = await opened();
  await page.evaluate(async () => {
    const element = document.querySelector<HTMLElement & {workbench: Workbench}>('seamwise-page');
    const cloth = {
      vertices: [
        [0, 0],
        [20, 0],
        [20, 20],
        [0, 20],
      ],
      edges: [0, 1, 2, 3].map((k) => ({endpoints: [k, (k + 1) % 4]})),
    };
    const text = JSON.stringify({pattern: {panels: {scarf: cloth}, stitches: []}});
    await element?.workbench.open({name: 'scarf.json', text});
  });
  const words = 'No seams yet: sew edges to each other, and the print is matched there.';
  await page.locator('sw-tables').getByText(words).waitFor();
  await expect.poll(() => rows(page, 'Pieces').count()).toBe(1);
  await expect.poll(() => table(page, 'Seams').isVisible()).toBe(true);
});
