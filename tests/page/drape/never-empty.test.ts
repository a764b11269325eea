/** The drape keeps its page responsive: it is never empty, and keys alone reach all of it. */
import type {Page} from 'playwright-core';
import {expect, it, vi} from 'vitest';

import type {SeamwisePage} from '@/app/page.js';
import {showSample, smallest, solved, usePage} from '../../support/page/page.js';
import {frames} from '../../support/page/waiting.js';

vi.setConfig({testTimeout: 180_000}); // a busy machine is slow at everything

const openPage = usePage();

const status = (page: Page): Promise<string | null> =>
  page.locator('sw-drape-pane [role=status]').textContent();

it(
  'never shows an empty view while print, colours and size change',
  {tags: ['thorough']},
  async () => {
    const page = await openPage({
      viewport: {width: 1300, height: 800},
      reducedMotion: 'no-preference',
    });
    await solved(page);
    await showSample(page, 'tee');
    await page.locator('sw-editor .views').getByRole('button', {name: 'Garment'}).click();
    await expect.poll(() => status(page), {timeout: 120_000}).toContain('view.');
    const stage = page.locator('sw-drape-pane .stage');
    /** An empty image takes next to no bytes. */
    const staysFull = async (): Promise<void> => {
      for (let k = 0; k < 6; k++) {
        expect((await stage.screenshot()).length).toBeGreaterThan(12_000);
        await frames(page, 4);
      }
    };
    await page
      .getByRole('radio', {name: 'Majolica'})
      .or(page.getByText('Majolica'))
      .first()
      .click();
    await staysFull();
    await page.evaluate(() => {
      const {workbench} = document.querySelector<SeamwisePage>('seamwise-page') ?? {};
      const print = workbench?.history.design?.print;
      if (print) workbench.history.change({print: {...print, size: {...print.size, width: 13}}});
    });
    await staysFull();
    await page.getByLabel('Size', {exact: true}).selectOption('l');
    await staysFull();
    await solved(page);
    await staysFull();
  },
);

it('is looked at and walked over by keys alone', async () => {
  const page = await openPage({query: smallest, viewport: {width: 1100, height: 640}});
  await solved(page);
  const pressed = async (name: string): Promise<void> => {
    for (let k = 0; k < 80; k++) {
      await page.keyboard.press('Tab');
      const here = await page.evaluate(() => {
        let at = document.activeElement;
        while (at?.shadowRoot?.activeElement) at = at.shadowRoot.activeElement;
        return `${at?.localName} ${at?.getAttribute('aria-label') ?? at?.textContent.trim()}`;
      });
      if (here === name) return;
    }
    throw new Error(`${name} is not reached by Tab.`);
  };
  await pressed('button Garment');
  await page.keyboard.press('Enter');
  await expect.poll(() => status(page), {timeout: 120_000}).toContain('Three-quarter view.');
  await pressed('div Garment, worn');
  for (const [key, said] of [
    ['2', 'Back view.'],
    ['3', 'View from the left.'],
    ['4', 'View from the right.'],
    ['5', 'Three-quarter view.'],
    ['1', 'Front view.'],
  ] as const) {
    await page.keyboard.press(key);
    await expect.poll(() => status(page), {timeout: 20_000}).toContain(said);
  }
  const pieces = await page.evaluate(() => {
    const {workbench} = document.querySelector<SeamwisePage>('seamwise-page') ?? {};
    return workbench?.sheet.scenes?.now.pieces.map(({label}) => label) ?? [];
  });
  expect(pieces.length).toBeGreaterThan(2);
  for (const label of pieces) {
    await page.keyboard.press('n');
    await expect.poll(() => status(page), {timeout: 20_000}).toContain(`${label}. `);
  }
  await page.keyboard.press('p');
  await expect.poll(() => status(page)).toContain(`${pieces.at(-2) ?? ''}. `);
  await page.keyboard.press('Escape');
  await expect.poll(() => status(page)).not.toContain(`${pieces.at(-2) ?? ''}. `);
});
