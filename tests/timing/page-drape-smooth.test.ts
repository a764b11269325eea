/** The time for which scripts block the page while a garment is draped. */
import type {Page} from 'playwright-core';
import {expect, it, vi} from 'vitest';

import {solved, usePage} from '../support/page/page.js';
import {scriptRuns} from '../support/page/script-runs.js';

vi.setConfig({testTimeout: 180_000}); // a busy machine is slow at everything

const openPage = usePage();

const status = (page: Page): Promise<string | null> =>
  page.locator('sw-drape-pane [role=status]').textContent();

it('has no script that runs for more than 50 ms while a drape is shown and settles', async () => {
  const page = await openPage({
    viewport: {width: 1300, height: 800},
    reducedMotion: 'no-preference',
  });
  await solved(page);
  await page.waitForTimeout(3000); // excludes the searches after an answer
  const runs = await scriptRuns(page, async () => {
    await page.locator('sw-editor .views').getByRole('button', {name: 'Garment'}).click();
    await expect.poll(() => status(page), {timeout: 120_000, interval: 500}).toContain('view.');
  });
  expect(runs.length).toBeGreaterThan(10);
  // a shared machine sometimes interrupts the process
  expect(runs[1]).toBeLessThan(50);
});
