/** Several garments on one fabric: adding, copies, colours, files and undo. */
import {expect, it} from 'vitest';

import type {LayPlan} from '@/model/result/marker-plan.js';
import {button, saved, smallest, usePage} from '../../support/page/page.js';
import {layoutOf, pane, panel, rowOf} from '../../support/page/marker.js';

const openPage = usePage();

it('lays another size and several copies on one fabric, each in its colour, and takes them back', async () => {
  const page = await layoutOf(await openPage({query: smallest}));
  const pieces = pane(page).locator('.piece');
  const list = panel(page).locator('sw-marker-garments li');
  await expect.poll(() => panel(page).locator('#add option[value="size:s"]').count()).toBe(1);
  await panel(page).locator('#add').selectOption('size:s');
  await expect.poll(() => pieces.count(), {timeout: 60_000}).toBe(8);
  await expect
    .poll(() => list.allInnerTexts())
    .toEqual([
      expect.stringMatching(/^A\s+Tee, M[^]* cm of the length/),
      expect.stringMatching(/^B\s+Tee, S[^]* cm of the length/),
    ]);
  await expect.poll(() => pane(page).locator('.piece.of-1').count()).toBe(4);
  await expect.poll(() => rowOf(page, 'B Front').count()).toBe(1);

  const copies = list.nth(1).getByLabel('Copies');
  await copies.fill('2');
  await copies.press('Enter');
  await expect.poll(() => pieces.count(), {timeout: 60_000}).toBe(12);
  const plan = JSON.parse(await saved(page, 'Save fabric layout (JSON)')) as LayPlan;
  expect(plan.garments?.map((one) => one.copies)).toEqual([1, 2]);
  expect(await saved(page, 'Save B Tee, S alone (DXF)')).toContain('B Front');

  await button(page, 'Undo').click();
  await expect.poll(() => pieces.count()).toBe(8);
  await list.nth(1).getByRole('button', {name: 'Remove Tee, S from the fabric'}).click();
  await expect.poll(() => pieces.count(), {timeout: 60_000}).toBe(4);
  await button(page, 'Undo').click();
  await expect.poll(() => pieces.count()).toBe(8);
});
