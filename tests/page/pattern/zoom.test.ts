/** Zoom of the pattern: in per cent, by menu, by typing, by keys. */
import type {Page} from 'playwright-core';
import {expect, it, vi} from 'vitest';

import type {PatternPane} from '@/editor/pattern/pattern-pane.js';
import {solved, usePage} from '../../support/page/page.js';

vi.setConfig({testTimeout: 180_000}); // a busy machine is slow at everything

const openPage = usePage();

/** Scale at 100 %. [CSS px per cm] */
const trueScale = 96 / 2.54;

const scale = (page: Page): Promise<number> =>
  page.locator('sw-pattern').evaluate((pane: PatternPane) => pane.view?.scale ?? NaN);
const zoom = (page: Page) => page.getByRole('button', {name: /^Zoom, /});
const sizes = (page: Page) => page.getByRole('dialog', {name: 'Zoom'});

it(
  'says beside its buttons how large the pattern is, and shows it at the size that is chosen',
  {tags: ['thorough']},
  async () => {
    const page = await openPage();
    await solved(page);
    const fitted = await scale(page);
    const percent = async (): Promise<number> => Number.parseFloat(await zoom(page).innerText());
    expect(await percent()).toBe(Math.round((100 * fitted) / trueScale));
    await zoom(page).click();
    await sizes(page).getByRole('button', {name: '100 %'}).click();
    expect(await scale(page)).toBeCloseTo(trueScale, 6);
    expect(await percent()).toBe(100);
    await sizes(page).waitFor({state: 'hidden'});
    await page.getByRole('button', {name: 'Zoom in', exact: true}).click();
    await expect.poll(percent).toBe(140);
    await zoom(page).click();
    await sizes(page).getByRole('button', {name: 'Show all'}).click();
    expect(await scale(page)).toBeCloseTo(fitted, 6);
  },
);

it('takes a size that is typed, by keys alone, and gives the focus back', async () => {
  const page = await openPage();
  await solved(page);
  await page.getByRole('application', {name: 'Pattern'}).focus();
  await page.keyboard.press('z');
  const field = sizes(page).getByRole('spinbutton', {name: 'Zoom in per cent'});
  await field.waitFor();
  await expect
    .poll(() =>
      field.evaluate((input) => (input.getRootNode() as ShadowRoot).activeElement === input),
    )
    .toBe(true);
  await field.fill('5000');
  await page.keyboard.press('Enter');
  await page.getByText('From 1 to 1000.').waitFor();
  await field.fill('75');
  await page.keyboard.press('Enter');
  await sizes(page).waitFor({state: 'hidden'});
  expect(await scale(page)).toBeCloseTo(0.75 * trueScale, 6);
  await expect
    .poll(() => zoom(page).evaluate((it) => (it.getRootNode() as ShadowRoot).activeElement === it))
    .toBe(true);
  await page.keyboard.press('Enter');
  await sizes(page).waitFor();
  await page.keyboard.press('Escape');
  await sizes(page).waitFor({state: 'hidden'});
});

it('keeps all tools of the pattern in one row at every width', {tags: ['thorough']}, async () => {
  const page = await openPage();
  await solved(page);
  for (const width of [390, 820, 1280]) {
    await page.setViewportSize({width, height: 844});
    const tops = await page
      .getByRole('group', {name: 'View'})
      .locator('button:visible')
      .evaluateAll((all) => all.map((one) => one.getBoundingClientRect()).map(({top}) => top));
    expect(new Set(tops).size, `${width}`).toBe(1);
    const bar = await page.getByRole('group', {name: 'View'}).boundingBox();
    expect((bar?.x ?? NaN) + (bar?.width ?? NaN), `${width}`).toBeLessThanOrEqual(width);
  }
});
