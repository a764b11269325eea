/** Folds by two places on a piece, made and changed by keys and fields. */
import type {Page} from 'playwright-core';
import {expect, it, vi} from 'vitest';

import type {SeamwisePage} from '@/app/page.js';
import type {GarmentDocument} from '@/model/garment/garment-document.js';
import {button, solved, usePage} from '../../support/page/page.js';

vi.setConfig({testTimeout: 300_000}); // a busy machine is slow at everything

const openPage = usePage();

const garmentOf = (page: Page): Promise<GarmentDocument> =>
  page.locator('seamwise-page').evaluate((element) => {
    const {garment} = (element as SeamwisePage).workbench.solving;
    if (!garment) throw new Error('There is no garment.');
    return garment;
  });

/** Kinds of all folds, and the number of edges of the first piece. */
async function foldsOf(page: Page): Promise<readonly [readonly string[], number]> {
  const {pieces} = await garmentOf(page);
  const kinds = pieces.flatMap(({folds = []}) => folds.map(({kind}) => kind));
  return [kinds, pieces[0]?.outline.length ?? 0];
}

it('folds a piece and its mirrored side, changes the kind, and takes all of it back', async () => {
  const page = await openPage({query: '?garment=garments/tee-m.json'});
  await solved(page);
  const [, edges] = await foldsOf(page);
  await button(page, 'Folds').click();
  const bar = page.locator('sw-fold-bar');
  await bar.getByText('No folds yet').waitFor();
  await page.locator('seamwise-page').evaluate((element) => {
    (element as SeamwisePage).workbench.selection.select({kind: 'piece', piece: 0});
  });
  await page.getByRole('application', {name: 'Pattern'}).focus();
  const hint = page.getByRole('status', {name: 'What to do next'});
  await page.keyboard.press('Enter');
  await hint.filter({hasText: 'Enter sets it'}).waitFor();
  await page.keyboard.press('ArrowDown'); // to a corner or a middle
  for (let k = 0; k < 4; k++) await page.keyboard.press('ArrowRight');
  await page.keyboard.press('Enter');
  await hint.filter({hasText: 'second line'}).waitFor();
  for (let k = 0; k < 3; k++) await page.keyboard.press('ArrowRight');
  await page.keyboard.press('Enter');
  await hint.filter({hasText: /^Knife pleat on Front/}).waitFor();
  const [kinds, divided] = await foldsOf(page);
  expect(kinds).toEqual(['knife', 'knife']);
  expect(divided).toBeGreaterThan(edges);
  await bar.getByLabel('Kind').selectOption('inverted');
  await expect.poll(() => foldsOf(page)).toEqual([['inverted', 'inverted'], divided]);
  await bar.getByRole('button', {name: 'Remove'}).click();
  await expect.poll(() => foldsOf(page)).toEqual([[], edges]);
  await button(page, 'Undo').click();
  await expect.poll(async () => (await foldsOf(page))[0]).toEqual(['inverted', 'inverted']);
});
