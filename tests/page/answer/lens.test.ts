/** The seam lens, tested on a raglan shirt of 12 seams. */
import type {Locator, Page} from 'playwright-core';
import {expect, it} from 'vitest';

import {button, drawn, showSample, usePage} from '../../support/page/page.js';

const openPage = usePage();

const lens = (page: Page): Locator => page.getByRole('group', {name: 'Close-up of a seam'});
async function name(page: Page): Promise<string | null> {
  await drawn(lens(page));
  return lens(page).getByRole('heading').textContent();
}
const seam = (page: Page, words: string): Locator =>
  page
    .getByRole('table', {name: 'Seams', exact: true})
    .getByRole('rowheader', {name: new RegExp(`^${words}`)});
const slider = (page: Page): Locator => lens(page).getByRole('slider', {name: 'Before and after'});

/** Image of both sides of the seam. */
const seen = async (page: Page): Promise<string> =>
  (await page.locator('sw-lens-strip canvas').screenshot()).toString('base64');

async function opened(): Promise<Page> {
  const page = await openPage();
  await showSample(page, 'raglan');
  await slider(page).waitFor();
  return page;
}

it('shows the seam that is selected', async () => {
  const page = await opened();
  await seam(page, 'Centre back').click();
  expect(await name(page)).toBe('Centre back');
  await lens(page).getByText('Back left', {exact: true}).waitFor();
  await lens(page).getByText('Back right', {exact: true}).waitFor();
});

it('shows the seam that the pointer is over, until it leaves', {tags: ['thorough']}, async () => {
  const page = await opened();
  await seam(page, 'Centre back').click();
  await seam(page, 'Centre front').hover();
  expect(await name(page)).toBe('Centre front');
  await page.getByRole('heading', {name: 'Seamwise'}).hover();
  expect(await name(page)).toBe('Centre back');
});

it('keeps a pinned seam until Escape', {tags: ['thorough']}, async () => {
  const page = await opened();
  await seam(page, 'Centre back').click();
  await lens(page).getByRole('button', {name: 'Pin'}).click();
  await seam(page, 'Centre front').click();
  expect(await name(page)).toBe('Centre back');
  await lens(page).press('Escape');
  expect(await name(page)).toBe('Centre front');
});

it('goes along the list of seams and back', {tags: ['thorough']}, async () => {
  const page = await opened();
  await seam(page, 'Centre front').click();
  const first = await name(page);
  await button(page, 'Next seam').click();
  await expect.poll(() => name(page)).not.toBe(first);
  await lens(page).press('ArrowUp');
  await expect.poll(() => name(page)).toBe(first);
});

it('wipes between before and after', {tags: ['thorough']}, async () => {
  const page = await opened();
  await page
    .getByRole('status', {name: 'Progress'})
    .filter({hasText: /^Matched in/})
    .waitFor({timeout: 60_000});
  await seam(page, 'Centre back').click();
  await slider(page).fill('0');
  const after = await seen(page);
  await slider(page).fill('100');
  await expect.poll(() => seen(page), {timeout: 20_000}).not.toBe(after);
});

it('tells where on the seam the pointer is', {tags: ['thorough']}, async () => {
  const page = await opened();
  await seam(page, 'Centre back').click();
  expect(await name(page)).toBe('Centre back');
  await page.evaluate(() => {
    document.addEventListener('sw-lens-cursor', (event) => {
      const {detail} = event as CustomEvent<{share: number} | undefined>;
      document.documentElement.dataset.share = String(detail?.share.toFixed(2));
    });
  });
  const share = () => page.evaluate(() => document.documentElement.dataset.share);
  const {x, y, width, height} = (await page.locator('sw-lens-strip canvas').boundingBox()) ?? {
    x: 0,
    y: 0,
    width: 0,
    height: 0,
  };
  await page.mouse.move(x + width / 2, y + height / 2 - 5);
  await expect.poll(share).toMatch(/^0\.(49|50|51)$/);
  await page.getByRole('heading', {name: 'Seamwise'}).hover();
  await expect.poll(share).toBe('undefined');
});
