/** The page without a network, after a first visit. */
import type {Page} from 'playwright-core';
import {expect, it, vi} from 'vitest';

import {designOf} from '../../support/page/design.js';
import {chooseGroup, groupOf, quiet, reloaded} from '../../support/page/quiet.js';
import {button, solved, usePage} from '../../support/page/page.js';

vi.setConfig({testTimeout: 180_000}); // a busy machine is slow at everything

const openPage = usePage();

/** Opens the page and waits until the browser has cached it. */
async function keptPage(): Promise<Page> {
  const page = await quiet(openPage, {
    serviceWorkers: 'allow',
    // the browser itself reports unreachable files
    maySay: /net::ERR_INTERNET_DISCONNECTED|Failed to fetch|net::ERR_FAILED/,
  });
  await page.waitForFunction(() => navigator.serviceWorker.controller !== null, undefined, {
    timeout: 60_000,
  });
  await page.waitForFunction(async () => {
    const cache = await caches.open('seamwise-samples');
    return (await cache.match('garments/asymmetric-dress-m.json')) !== undefined;
  });
  return page;
}

const notice = (page: Page, text: string) => page.getByText(text);

it(
  'works without a network after the first visit, with all that was done',
  {tags: ['thorough']},
  async () => {
    const page = await keptPage();
    await chooseGroup(page, 'pgg');
    const before = await designOf(page);
    await page.context().setOffline(true);
    await reloaded(page);
    expect(await designOf(page)).toEqual(before);
    await button(page, 'Match print').click();
    await solved(page);
    await button(page, 'Undo').click();
    expect(await groupOf(page)).toBe('cm');
  },
);

it(
  'says what is not on the device yet, and brings it once the network is back',
  {tags: ['thorough']},
  async () => {
    const page = await keptPage();
    await page.context().setOffline(true);
    await page.getByLabel('Garment', {exact: true}).selectOption('apron');
    await notice(page, 'Apron is not on this device yet').waitFor();
    expect((await designOf(page)).garment.name).toBe('asymmetric-dress-m.json');
    await page.context().setOffline(false);
    await expect
      .poll(async () => (await designOf(page)).garment.name, {timeout: 20_000})
      .toBe('apron-m.json');

    await page.context().setOffline(true);
    await chooseGroup(page, 'p4');
    await button(page, 'Moss').click();
    await notice(page, 'is not on this device yet').waitFor();
    await page.context().setOffline(false);
    await notice(page, 'is not on this device yet').waitFor({state: 'hidden'});
  },
);

it(
  'says that a new version is there, and shows it after a reload',
  {tags: ['thorough']},
  async () => {
    const page = await keptPage();
    await chooseGroup(page, 'pgg');
    // simulates an earlier version of the page and a newer service worker on the host
    await page.evaluate(async () => {
      document.querySelector('script[type=module]')?.setAttribute('src', './assets/older.js');
      await navigator.serviceWorker.register('service-worker.js?newer');
    });
    await notice(page, 'A new version is ready.').waitFor();
    await Promise.all([page.waitForEvent('load'), button(page, 'Reload').click()]);
    await expect.poll(() => groupOf(page), {timeout: 20_000}).toBe('pgg');
  },
);

it('can be installed: its manifest names icons that are there', async () => {
  const page = await openPage();
  const icons = await page.evaluate(async () => {
    const link = document.querySelector<HTMLLinkElement>('link[rel=manifest]');
    const manifest = (await (await fetch(link?.href ?? '')).json()) as {
      icons: {src: string; sizes: string}[];
    };
    return Promise.all(
      manifest.icons.map(async ({src, sizes}) => {
        const image = new Image();
        image.src = new URL(src, link?.href).href;
        await image.decode();
        return [sizes, `${image.naturalWidth}x${image.naturalHeight}`];
      }),
    );
  });
  for (const [stated, real] of icons.slice(1)) expect(real).toBe(stated);
  const session = await page.context().newCDPSession(page);
  const {errors} = await session.send('Page.getAppManifest');
  expect(errors).toEqual([]);
});
