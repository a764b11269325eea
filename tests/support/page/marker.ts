/** The fabric layout on the page. */
import type {Locator, Page} from 'playwright-core';
import {expect} from 'vitest';

import type {SeamwisePage} from '@/app/page.js';
import {showSample, solved} from './page.js';

export const pane = (page: Page): Locator => page.locator('sw-marker-pane');
export const panel = (page: Page): Locator => page.locator('sw-marker-panel');
export const status = (page: Page): Promise<string | null> =>
  pane(page).locator('[role=status]').textContent();
/** The message below the fabric. */
export const said = async (page: Page): Promise<string> =>
  (await pane(page).locator('.said').textContent())?.trim() ?? '';
export const bought = (page: Page): Promise<string | null> =>
  panel(page).locator('h2').textContent();
/** Figures of the plan. */
export const facts = (page: Page): Promise<string> => panel(page).locator('.facts').innerText();
export const rowOf = (page: Page, name: string): Locator =>
  panel(page).locator('.pieces').getByRole('row', {name});

/** Waits until the layout is done. */
export async function laid(page: Page): Promise<void> {
  const state = () => pane(page).locator('.pane').getAttribute('data-state');
  await expect.poll(state, {timeout: 60_000}).toBe('done');
  await expect.poll(() => bought(page)).toMatch(/^Buy \d/);
}

/** Sets the number of garments to two and waits; the garment has four pieces. */
export async function layTwice(page: Page): Promise<void> {
  const garments = panel(page).getByLabel('Copies');
  await garments.fill('2');
  await garments.press('Enter');
  await expect.poll(() => pane(page).locator('.piece').count(), {timeout: 60_000}).toBe(8);
  await laid(page);
}

/** Opens the layout of a tee in a print that may be upside down. */
export async function layoutOf(page: Page): Promise<Page> {
  await solved(page);
  await showSample(page, 'tee');
  await page.evaluate(() => {
    const {workbench} = document.querySelector<SeamwisePage>('seamwise-page') ?? {};
    const print = workbench?.history.design?.print;
    if (print)
      workbench.history.change({print: {...print, group: 'p2', oneWay: false}, symmetry: 'none'});
  });
  await solved(page);
  await page.locator('sw-editor .views').getByRole('button', {name: 'Fabric layout'}).click();
  await laid(page);
  return page;
}
