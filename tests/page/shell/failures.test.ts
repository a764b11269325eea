/** Messages and behaviour of the page when a part fails or is cancelled. */
import type {Page} from 'playwright-core';
import {describe, expect, it, vi} from 'vitest';

import {sampleOf} from '../../support/level.js';
import {designOf} from '../../support/page/design.js';
import {choose, jsonFile, squares} from '../../support/page/files.js';
import {button, cancelNext, progress, smallest, solved, usePage} from '../../support/page/page.js';
import {printRadio} from '../../support/page/prints.js';

vi.setConfig({testTimeout: 180_000}); // a busy machine is slow at everything

const openPage = usePage();

const says = (page: Page, words: RegExp): Promise<void> =>
  progress(page).filter({hasText: words}).waitFor({timeout: 60_000});

const group = (page: Page, name: string): Promise<void> => printRadio(page, name).click();

/**
 * Breaks the solver in the next solve that the page shows; simultaneous searches for remedies are
 * spared.
 */
async function sabotage(page: Page, end: 'throw' | 'close'): Promise<void> {
  const [worker] = page.workers();
  if (!worker) throw new Error('There is no solver.');
  await worker.evaluate((how) => {
    const scope = self as unknown as {postMessage: unknown; close(): void};
    const post = self.postMessage.bind(self);
    scope.postMessage = (message: {hook?: string}, options?: StructuredSerializeOptions) => {
      post(message, options);
      if (message.hook !== 'onPattern') return;
      scope.postMessage = post;
      if (how === 'close') scope.close();
      else
        setTimeout(() => {
          throw new Error('out of order');
        });
    };
  }, end);
}

describe('a solver that breaks', () => {
  it.each(sampleOf(1, ['throw', 'close'] as const))(
    'by a %s is started again, and answers',
    async (end) => {
      const page = await openPage({query: smallest, maySay: /out of order/});
      await solved(page);
      await sabotage(page, end);
      await group(page, 'pgg');
      await page
        .getByText('The calculation stopped and was restarted; nothing is lost.')
        .waitFor({timeout: 50_000});
      await solved(page);
      expect((await designOf(page)).print.group).toBe('pgg');
      await page.getByRole('status', {name: 'Result', exact: true}).waitFor();
    },
  );
});

it('says so when the solver cannot be loaded, and solves once it can be', async () => {
  const page = await openPage({
    ...{query: smallest, maySay: /404|wasm|^Aborted|ArrayBuffer instantiation/i},
  });
  await solved(page);
  await page.route('**/*.wasm', (route) => route.fulfill({status: 404, body: 'gone'}));
  await page.reload();
  await says(page, /^Not matched$/);
  const alerts = page.getByRole('alert');
  await alerts.filter({hasText: /^\s*The solver could not be loaded.*\.\s*$/}).waitFor();
  await expect.poll(() => alerts.count()).toBe(1);
  const {garment} = await designOf(page);
  expect(garment.name).toContain('tee-xs');
  await page.unroute('**/*.wasm');
  await button(page, 'Match print').click();
  await solved(page);
});

it(
  'solves in the page itself where the worker cannot be started, and says why',
  {tags: ['thorough']},
  async () => {
    const page = await openPage({maySay: /404/});
    await page.route('**/solver.worker*', (route) => route.fulfill({status: 404, body: 'gone'}));
    await page.reload();
    await solved(page);
    await page.getByText(/^The solver's worker could not be started from /).waitFor();
    await expect.poll(() => page.workers()).toEqual([]);
    await group(page, 'pgg');
    await solved(page);
    expect((await designOf(page)).print.group).toBe('pgg');
  },
);

it('takes a garment where no sample can be read', async () => {
  const page = await openPage({maySay: /Failed to load resource/});
  await page.route('**/samples.json', (route) => route.abort());
  await page.reload();
  await page.getByText('Open a garment to begin', {exact: true}).waitFor();
  const alert = page.getByRole('alert');
  await alert.filter({hasText: 'samples.json cannot be reached; check the connection.'}).waitFor();
  await choose(page, 'My pattern', jsonFile('own.json', squares(40)));
  await solved(page);
  expect((await designOf(page)).garment.name).toBe('own.json');
});

it('still has its tables where nothing can be drawn', {tags: ['thorough']}, async () => {
  const page = await openPage({maySay: /WebGL/});
  await page.addInitScript(() => {
    HTMLCanvasElement.prototype.getContext = () => null;
  });
  await page.reload();
  await page.getByText('This browser cannot draw the pattern: it has no WebGL 2.').waitFor();
  await solved(page);
  for (const name of ['Pieces', 'Seams']) {
    const rows = page.getByRole('table', {name, exact: true}).getByRole('row');
    await expect.poll(() => rows.count()).toBeGreaterThan(5);
  }
});

it(
  'says that what is shown is out of date once a solve is cancelled',
  {tags: ['thorough']},
  async () => {
    const page = await openPage();
    await solved(page);
    const cancelled = await cancelNext(page);
    await group(page, 'pgg');
    await cancelled();
    await says(page, /^Cancelled/);
    await page.getByText('The picture is out of date').waitFor();
    await expect.poll(() => button(page, 'Cancel').count()).toBe(0);
    await button(page, 'Match print').click();
    await solved(page);
    await expect.poll(() => page.getByText('The picture is out of date').count()).toBe(0);
  },
);

it(
  'waits for Match print where nobody wants to match with every change',
  {tags: ['thorough']},
  async () => {
    const page = await openPage();
    await solved(page);
    await page.getByRole('switch', {name: 'Match after each change'}).press('Space');
    await group(page, 'cmm');
    await says(page, /^Out of date/);
    await page.getByText('The picture is out of date').waitFor();
    await button(page, 'Save …').click();
    await expect.poll(() => button(page, 'Save result').isDisabled()).toBe(true);
    await page.keyboard.press('Escape');
    await expect.poll(() => button(page, 'Cancel').count()).toBe(0);
    await button(page, 'Match print').click();
    await solved(page);
    await page.getByRole('switch', {name: 'Match after each change'}).press('Space');
    await group(page, 'pgg');
    await solved(page);
  },
);
