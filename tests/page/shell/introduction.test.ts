/** The first visit: the garment before the solver is there, and three ways to begin. */
import type {Page} from 'playwright-core';
import {expect, it, vi} from 'vitest';

import {askedSymmetries} from '@/model/design/design.js';
import {designOf} from '../../support/page/design.js';
import {button, solved, usePage} from '../../support/page/page.js';
import {printRadio} from '../../support/page/prints.js';

vi.setConfig({testTimeout: 180_000}); // a busy machine is slow at everything

const openPage = usePage();
/** Software rendering takes as long to draw the worn garment as it has pixels. */
const small = {viewport: {width: 1100, height: 640}};
const phone = {viewport: {width: 390, height: 844}, hasTouch: true, isMobile: true};

const ways = (page: Page) => page.getByRole('group', {name: 'Start', exact: true});

/** Sum of the layout shifts since the page was opened. */
const shifts = (page: Page): Promise<number> =>
  page.evaluate(async () => {
    const found: PerformanceEntry[] = [];
    const observer = new PerformanceObserver((list) => found.push(...list.getEntries()));
    observer.observe({type: 'layout-shift', buffered: true});
    for (let frame = 0; frame < 2; frame++) await new Promise(requestAnimationFrame);
    found.push(...observer.takeRecords());
    return found.reduce(
      (sum, entry) => sum + (entry as PerformanceEntry & {value: number}).value,
      0,
    );
  });

it('shows the garment in its print without the solver, and does not load the drape', async () => {
  const page = await openPage({isFirst: true, query: 'samples.json', maySay: /404/}); // a file of the same host
  const asked: string[] = [];
  await page.route('**/*.wasm', (route) => void asked.push(route.request().url())); // no answer
  await page.addInitScript(() => {
    addEventListener('sw-drawn', (event) => {
      const [part] = event.composedPath() as Element[];
      if (part?.localName === 'sw-drape-pane') document.documentElement.dataset.drawn = 'yes';
    });
  });
  await page.goto(new URL('.', page.url()).href);
  await page.locator('html[data-drawn=yes]').waitFor({state: 'attached'});
  expect(asked.map((url) => url.split('/').at(-1))).toEqual([expect.stringMatching(/^seamwise-/)]);
});

it('begins with a symmetric garment and three ways, which go with the first action', async () => {
  const page = await openPage({isFirst: true, ...small});
  await solved(page);
  const {garment, ...design} = await designOf(page);
  expect(garment.sample?.style).toBe('six-gore-skirt');
  expect(askedSymmetries(design).map(({kind}) => kind)).toEqual(expect.arrayContaining(['pair']));
  for (const name of [/^My pattern:/, /^My fabric:/, /^A sample:/])
    await expect.poll(() => ways(page).getByRole('button', {name}).count()).toBe(1);
  expect(await shifts(page)).toBe(0);
  await printRadio(page, 'pmm').press('Space');
  await expect.poll(() => ways(page).count()).toBe(0);
  const later = await openPage({beside: page, isFirst: true});
  await solved(later);
  await expect.poll(() => ways(later).count()).toBe(0);
});

it('opens the files of a user from the first picture, on a phone', async () => {
  const page = await openPage({isFirst: true, ...phone});
  await ways(page).waitFor();
  const [chooser] = await Promise.all([
    page.waitForEvent('filechooser'),
    ways(page)
      .getByRole('button', {name: /^My pattern:/})
      .tap(),
  ]);
  expect(chooser.isMultiple()).toBe(false);
  await expect.poll(() => ways(page).count()).toBe(0);
});

it('shows the garment unmatched while Before is pressed', async () => {
  const page = await openPage({isFirst: true, ...small});
  await solved(page);
  const before = button(page, 'Before').first();
  await before.hover();
  await page.mouse.down();
  await expect.poll(() => before.getAttribute('aria-pressed')).toBe('true');
  await page.mouse.up();
  await expect.poll(() => before.getAttribute('aria-pressed')).toBe('false');
});
