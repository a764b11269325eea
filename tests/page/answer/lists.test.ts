/**
 * Tables of pieces and seams, linked with the pattern in both directions. Tested on a raglan shirt:
 * 8 pieces, 12 seams.
 */
import type {Locator, Page} from 'playwright-core';
import {expect, it} from 'vitest';

import type {Design} from '@/model/design/design.js';
import type {Target, Workbench} from '@/workbench/workbench.js';
import {designOf} from '../../support/page/design.js';
import {button, showSample, smallest, solved, usePage} from '../../support/page/page.js';

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
  const page = await openPage({query: smallest});
  await showSample(page, 'raglan');
  await row(page, 'Centre back').waitFor();
  return page;
}

/** Numbers of a column after the first, from top to bottom. */
const column = async (page: Page, name: 'Pieces' | 'Seams', number: number): Promise<number[]> =>
  (await rows(page, name).locator(`td:nth-of-type(${number})`).allTextContents()).map(parseFloat);

const falling = (numbers: readonly number[]): number[] => [...numbers].sort((a, b) => b - a);

it('lists the seams of a sewist, the most visible first, and folds the others', async () => {
  const page = await opened();
  await solved(page);
  await expect.poll(() => rows(page, 'Pieces').count()).toBe(8);
  const seams = table(page, 'Seams').locator('tbody');
  const names = () => seams.getByRole('rowheader').locator('.seam > span:nth-child(2)');
  const shown = (await names().allInnerTexts()).filter((name) => name !== '');
  expect(shown[0]).toBe('Centre front');
  expect(shown).not.toContain('Sleeve seams');
  const others = seams.getByRole('button', {name: /^\d+ others: /});
  await others.click();
  await expect.poll(() => others.getAttribute('aria-expanded')).toBe('true');
  await row(page, 'Sleeve seam').first().waitFor();
});

it('has a word beside each mark, and the numbers of the headline', async () => {
  const page = await opened();
  await solved(page);
  const result = page.getByRole('status', {name: 'Result', exact: true});
  await expect.poll(() => result.innerText()).toMatch(/visible seams? match/);
  const [, some, all] = /^(?:(\d+) of|All) (\d+) visible/.exec(await result.innerText()) ?? [];
  const states = await table(page, 'Seams')
    .locator('tbody tr:not([hidden]) .number')
    .allInnerTexts();
  for (const words of states) expect(words).toMatch(/^(matches|close|off|can’t match)/);
  const matched = states.filter((words) => words === 'matches').length;
  expect(matched).toBeLessThanOrEqual(Number(some ?? all)); // left and right share a line
  expect(states.length).toBeLessThanOrEqual(Number(all));
});

it(
  'sorts by a column, and the other way round when asked again',
  {tags: ['thorough']},
  async () => {
    const page = await opened();
    await solved(page);
    const header = table(page, 'Pieces').getByRole('columnheader', {name: 'Moved'});
    await header.getByRole('button').click();
    const moved = await column(page, 'Pieces', 1);
    expect(moved).toEqual(falling(moved));
    await header.getByRole('button').click();
    await expect.poll(() => header.getAttribute('aria-sort')).toBe('ascending');
    expect(await column(page, 'Pieces', 1)).toEqual(falling(moved).reverse());
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

it('decides by the menu of a line how much a seam counts, as one step each', async () => {
  const page = await opened();
  await solved(page);
  const centre = row(page, 'Centre back');
  await centre.getByRole('rowheader').click();
  await page.keyboard.press('ContextMenu');
  const menu = page.getByRole('menu', {name: 'More for: Centre back'});
  const item = (name: string): Locator => menu.getByRole('menuitemcheckbox', {name});
  await item('Match first').waitFor();
  await page.keyboard.press('ArrowDown');
  await page.keyboard.press('ArrowDown');
  await page.keyboard.press('Enter');
  expect(await options(page)).toMatchObject({weights: {1: 0.5}});
  await solved(page);
  await table(page, 'Seams')
    .getByRole('button', {name: /^\d+ others: /})
    .click();
  await button(page, 'More for: Centre back').click();
  await expect.poll(() => item('Hardly visible').getAttribute('aria-checked')).toBe('true');
  await item("Don't match").click();
  expect(await options(page)).toMatchObject({unmatched: [1]});
  await button(page, 'Undo').click();
  await button(page, 'Undo').click();
  expect((await options(page)).unmatched ?? []).toEqual([]);
  expect((await options(page)).weights ?? {}).toEqual({});
});

it('cuts a piece from plain fabric, or on a grain of its own', {tags: ['thorough']}, async () => {
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
  await button(page, 'Unpin: Front left').click();
  expect((await options(page)).pins).toEqual({});
});

it('says that a garment without seams has nothing to match', {tags: ['thorough']}, async () => {
  const page = await opened();
  await page.evaluate(async () => {
    const element = document.querySelector<HTMLElement & {workbench: Workbench}>('seamwise-page');
    const scarf = {
      vertices: [
        [0, 0],
        [20, 0],
        [20, 20],
        [0, 20],
      ],
      edges: [0, 1, 2, 3].map((k) => ({endpoints: [k, (k + 1) % 4]})),
    };
    const text = JSON.stringify({pattern: {panels: {scarf}, stitches: []}});
    await element?.workbench.open({name: 'scarf.json', text});
  });
  const words = 'No seams yet: sew the edges together, and the print is matched there.';
  await page.locator('sw-seam-table').getByText(words).waitFor();
  await expect.poll(() => rows(page, 'Pieces').count()).toBe(1);
  await expect.poll(() => table(page, 'Seams').isVisible()).toBe(true);
});
