/** The garment as it is worn, on the page: beside its pattern or in its place, and what is meant in one is meant in both. */
import {expect, it} from 'vitest';

import type {SeamwisePage} from '@/app/page.js';
import {solved, usePage} from '../support/page.js';

const openPage = usePage();

it('shows the garment worn in place of the pattern, beside it, and marks in both what is picked in one', async () => {
  const page = await openPage({viewport: {width: 1300, height: 800}});
  await solved(page);
  const views = page.locator('sw-editor .views');
  const worn = page.locator('sw-worn');
  expect(await worn.count()).toBe(0);
  await views.getByRole('button', {name: 'Garment'}).click();
  const status = worn.locator('[role=status]');
  await expect.poll(() => status.textContent(), {timeout: 120_000}).toContain('Front view.');
  expect(await page.locator('sw-pattern').isVisible()).toBe(false);
  await views.getByRole('button', {name: 'Both'}).click();
  expect(await page.locator('sw-pattern').isVisible()).toBe(true);
  const picked = () =>
    page.evaluate(() => {
      const {workbench} = document.querySelector<SeamwisePage>('seamwise-page') ?? {};
      const {selected, pattern} = workbench ?? {};
      return selected?.kind === 'piece' ? pattern?.pieces[selected.piece]?.name : selected?.kind;
    });
  // room in the picture is found by trying: the middle of the chest is cloth
  const stage = await worn.locator('.stage').boundingBox();
  if (!stage) throw new Error('The garment has no stage.');
  const [x, y] = [stage.x + 0.5 * stage.width, stage.y + 0.42 * stage.height];
  await expect
    .poll(
      async () => {
        await page.mouse.click(x, y);
        return picked();
      },
      {timeout: 30_000},
    )
    .toBeTruthy();
  // what is picked elsewhere turns the camera to where it is
  await page.evaluate(() => {
    const {workbench} = document.querySelector<SeamwisePage>('seamwise-page') ?? {};
    const back = workbench?.pattern?.pieces.findIndex(({name}) => name.includes('back')) ?? -1;
    workbench?.select({kind: 'piece', piece: back});
  });
  await expect.poll(() => status.textContent(), {timeout: 30_000}).toContain('Back view.');
});

it('keeps the worn garment in sight while another print is on its way', async () => {
  const page = await openPage({viewport: {width: 1300, height: 800}});
  await solved(page);
  await page.locator('sw-editor .views').getByRole('button', {name: 'Garment'}).click();
  const worn = page.locator('sw-worn');
  const status = worn.locator('[role=status]');
  await expect.poll(() => status.textContent(), {timeout: 120_000}).toContain('view.');
  await page.evaluate(() => {
    const {workbench} = document.querySelector<SeamwisePage>('seamwise-page') ?? {};
    const print = workbench?.design?.print;
    if (print)
      workbench.change({print: {...print, size: {...print.size, width: 1.1 * print.size.width}}});
  });
  // never an empty picture, which takes next to no bytes
  for (let k = 0; k < 8; k++) {
    const picture = await worn.locator('.stage').screenshot();
    expect(picture.length).toBeGreaterThan(20_000);
    await page.waitForTimeout(150);
  }
  await expect.poll(() => status.textContent(), {timeout: 120_000}).toContain('view.');
});
