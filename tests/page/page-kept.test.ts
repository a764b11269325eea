/** What outlives a reload, and what travels to others. */
import type {Page} from 'playwright-core';
import {expect, it, vi} from 'vitest';

import type {SeamwisePage} from '../../web/src/app/page.js';
import {designOf} from '../support/page-design.js';
import {button, showSample, solved, usePage} from '../support/page.js';

vi.setConfig({testTimeout: 180_000}); // a busy machine is slow at everything

const openPage = usePage();

/** Nothing here needs an answer, nor much of a picture. */
const quietPage = async (options: Parameters<typeof openPage>[0] = {}): Promise<Page> => {
  const page = await openPage({viewport: {width: 640, height: 480}, ...options});
  const live = page.getByRole('switch', {name: 'Solve as I go', checked: true});
  await page.getByRole('switch', {name: 'Solve as I go'}).waitFor();
  if ((await live.count()) > 0) await live.press('Space');
  return page;
};

const choose = async (page: Page, group: string): Promise<void> => {
  await page.getByRole('radio', {name: new RegExp(`^${group},`)}).press('Space');
  await page.getByRole('radio', {name: new RegExp(`^${group},`), checked: true}).waitFor();
};

const groupOf = async (page: Page): Promise<string> => (await designOf(page)).print.group;

/** Once the page is there again. */
const reloaded = async (page: Page): Promise<void> => {
  await page.reload();
  await page.getByRole('radiogroup', {name: 'Wallpaper group'}).waitFor();
};

it('comes back to the same design after a reload during a solve, and solves it', async () => {
  const page = await openPage();
  await solved(page);
  await showSample(page, 'patchwork-jacket');
  const {garment} = await designOf(page);
  const left = button(page, 'Cancel').evaluate(async (cancel: HTMLButtonElement) => {
    while (cancel.disabled) await new Promise(requestAnimationFrame); // until a solve begins
    setTimeout(() => {
      location.reload();
    });
  });
  await Promise.all([
    page.waitForEvent('load'),
    left,
    page.getByRole('radio', {name: /^pgg\b/}).press('Space'),
  ]);
  await solved(page);
  const design = await designOf(page);
  expect(design.garment).toEqual(garment);
  expect(design.print.group).toBe('pgg');
});

it('keeps all steps over a reload', async () => {
  const page = await quietPage();
  const designs = [await designOf(page)];
  for (const name of ['Woven shirt', 'Best fit, any angle', 'Plum']) {
    await button(page, name).click();
    designs.push(await designOf(page));
  }
  await button(page, 'Undo').click();
  await reloaded(page);
  expect(await designOf(page)).toEqual(designs[2]);
  await button(page, 'Redo').click();
  expect(await designOf(page)).toEqual(designs[3]);
  for (const design of designs.slice(0, 3).reverse()) {
    await button(page, 'Undo').click();
    expect(await designOf(page)).toEqual(design);
  }
  expect(await button(page, 'Undo').isDisabled()).toBe(true);
});

it('keeps what is changed at the very moment of a reload', async () => {
  const page = await quietPage();
  await page.locator('seamwise-page').evaluate((element) => {
    const {desk} = element as SeamwisePage;
    for (const maxChangeCm of [0.2, 0.3]) desk.change({options: {maxChangeCm}});
    location.reload();
  });
  await expect
    .poll(async () => (await designOf(page)).options.maxChangeCm, {timeout: 20_000})
    .toBe(0.3);
  await button(page, 'Undo').click();
  expect((await designOf(page)).options.maxChangeCm).toBe(0.2);
  await reloaded(page);
  expect((await designOf(page)).options.maxChangeCm).toBe(0.2);
});

it('carries a design of samples in a link', async () => {
  const page = await openPage({permissions: ['clipboard-read', 'clipboard-write']});
  await solved(page);
  await showSample(page, 'tee');
  await page.getByLabel('Size', {exact: true}).selectOption('l');
  await button(page, 'Accept all symmetries').click();
  await button(page, 'Plum').click();
  await solved(page);
  const design = await designOf(page);
  expect(design.symmetries.length).toBeGreaterThan(0);
  await button(page, 'Save …').click();
  await button(page, 'Copy link').click();
  await page.getByText('The link is in the clipboard.').waitFor();
  const link = await page.evaluate(() => navigator.clipboard.readText());
  const other = await quietPage({query: new URL(link).hash});
  expect(await designOf(other)).toEqual(design);
  await reloaded(other);
  expect(await designOf(other)).toEqual(design);
});

it('takes up a link in a tab that shows something else, and keeps what is made of it', async () => {
  const page = await quietPage({permissions: ['clipboard-read', 'clipboard-write']});
  await choose(page, 'cmm');
  await page.evaluate(() => {
    const hash = `#design=${btoa(
      JSON.stringify({
        garment: {style: 'apron', size: 's'},
        print: {
          ...{group: 'pgg', size: {width: 8, height: 12, angleDeg: 90}, turnDeg: 0},
          ...{oneWay: false, cell: 'primitive', sample: {name: 'pgg', colourway: 'none'}},
        },
        ...{symmetries: [], method: 'best', options: {maxChangeCm: 0.5}},
      }),
    )}`;
    location.hash = hash;
  });
  await expect
    .poll(async () => (await designOf(page)).garment.name, {timeout: 20_000})
    .toBe('apron-s.json');
  await choose(page, 'p6m');
  await reloaded(page);
  const {garment, print} = await designOf(page);
  expect([garment.name, print.group]).toEqual(['apron-s.json', 'p6m']);
});

it('keeps work on a file that the address names', async () => {
  const page = await quietPage({query: '?garment=garments/tee-s.json'});
  await choose(page, 'pgg');
  await reloaded(page);
  const {garment, print} = await designOf(page);
  expect([garment.name, print.group]).toEqual(['tee-s.json', 'pgg']);
});

it('keeps two tabs apart that began with the same project', async () => {
  const page = await quietPage();
  await choose(page, 'pgg');
  await reloaded(page); // by now it is kept
  const [twin] = await Promise.all([
    page.context().waitForEvent('page'),
    page.evaluate(() => {
      open(location.href); // with all that this tab remembers
    }),
  ]);
  await twin.getByRole('radiogroup', {name: 'Wallpaper group'}).waitFor();
  expect(await groupOf(twin)).toBe('pgg');
  await choose(twin, 'cmm');
  await choose(page, 'p6m');
  await Promise.all([reloaded(twin), reloaded(page)]);
  expect([await groupOf(page), await groupOf(twin)]).toEqual(['p6m', 'cmm']);
});

it('lists recent projects, and opens one of them', async () => {
  const page = await quietPage();
  await page.getByLabel('Garment', {exact: true}).selectOption('apron');
  await expect.poll(async () => (await designOf(page)).garment.name).toBe('apron-m.json');
  const before = await designOf(page);
  await reloaded(page);
  const other = await quietPage({beside: page});
  expect((await designOf(other)).garment.name).toBe('asymmetric-dress-m.json');
  await button(other, 'Recent projects').click();
  const list = other.getByRole('region', {name: 'Recent projects'});
  await list.getByRole('button', {name: /apron-m\.json/}).click();
  await expect.poll(async () => (await designOf(other)).garment.name).toBe('apron-m.json');
  expect(await designOf(other)).toEqual(before);
  await button(other, 'Undo').click();
  expect((await designOf(other)).garment.name).toBe('asymmetric-dress-m.json');
});
