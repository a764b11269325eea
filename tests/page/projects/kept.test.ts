/** Data that outlive a reload, and links that share them. */
import type {Page} from 'playwright-core';
import {expect, it, vi} from 'vitest';

import type {SeamwisePage} from '@/app/page.js';
import {askedSymmetries} from '@/model/design/design.js';
import {designOf} from '../../support/page/design.js';
import {chooseGroup, groupOf, quiet, reloaded} from '../../support/page/quiet.js';
import {
  button,
  cancelButton,
  showSample,
  solved,
  usePage,
  type PageOptions,
} from '../../support/page/page.js';
import {printRadio} from '../../support/page/prints.js';

vi.setConfig({testTimeout: 180_000}); // a busy machine is slow at everything

const openPage = usePage();
const quietPage = (options?: PageOptions): Promise<Page> => quiet(openPage, options);

it(
  'comes back to the same design after a reload during a solve, and solves it',
  {tags: ['thorough']},
  async () => {
    const page = await openPage();
    await solved(page);
    await showSample(page, 'patchwork-jacket');
    const {garment} = await designOf(page);
    const left = cancelButton(page).evaluate(async (cancel: HTMLButtonElement) => {
      while (cancel.hidden) await new Promise(requestAnimationFrame); // waits for a solve
      setTimeout(() => {
        location.reload();
      });
    });
    await Promise.all([page.waitForEvent('load'), left, printRadio(page, 'pgg').press('Space')]);
    await solved(page);
    const design = await designOf(page);
    expect(design.garment).toEqual(garment);
    expect(design.print.group).toBe('pgg');
  },
);

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
  await expect.poll(() => button(page, 'Undo').isDisabled()).toBe(true);
});

it('keeps what is changed at the very moment of a reload', {tags: ['thorough']}, async () => {
  const page = await quietPage();
  await Promise.all([
    page.waitForEvent('load'),
    page.locator('seamwise-page').evaluate((element) => {
      const {workbench} = element as SeamwisePage;
      for (const maxChangeCm of [0.2, 0.3]) workbench.history.change({options: {maxChangeCm}});
      location.reload();
    }),
  ]);
  await expect
    .poll(async () => (await designOf(page)).options.maxChangeCm, {timeout: 20_000})
    .toBe(0.3);
  await button(page, 'Undo').click();
  expect((await designOf(page)).options.maxChangeCm).toBe(0.2);
  await reloaded(page);
  expect((await designOf(page)).options.maxChangeCm).toBe(0.2);
});

it('carries a design of samples in a link', {tags: ['thorough']}, async () => {
  const page = await openPage({permissions: ['clipboard-read', 'clipboard-write']});
  await solved(page);
  await showSample(page, 'tee');
  await page.getByLabel('Size', {exact: true}).selectOption('l');
  await expect.poll(async () => (await designOf(page)).garment.sample?.size).toBe('l');
  await button(page, 'Accept all symmetries').click();
  await button(page, 'Plum').click();
  await solved(page);
  const design = await designOf(page);
  expect(askedSymmetries(design).length).toBeGreaterThan(0);
  await button(page, 'Save …').click();
  await button(page, 'Copy link').click();
  await page.getByText('The link is copied.').waitFor();
  const link = await page.evaluate(() => navigator.clipboard.readText());
  const other = await quietPage({query: new URL(link).hash});
  expect(await designOf(other)).toEqual(design);
  await reloaded(other);
  expect(await designOf(other)).toEqual(design);
});

it(
  'takes up a link in a tab that shows something else, and keeps what is made of it',
  {tags: ['thorough']},
  async () => {
    const page = await quietPage({permissions: ['clipboard-read', 'clipboard-write']});
    await chooseGroup(page, 'cmm');
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
    await chooseGroup(page, 'p6m');
    await reloaded(page);
    const {garment, print} = await designOf(page);
    expect([garment.name, print.group]).toEqual(['apron-s.json', 'p6m']);
  },
);

it('keeps work on a file that the address names', {tags: ['thorough']}, async () => {
  const page = await quietPage({query: '?garment=garments/tee-s.json'});
  await chooseGroup(page, 'pgg');
  await reloaded(page);
  const {garment, print} = await designOf(page);
  expect([garment.name, print.group]).toEqual(['tee-s.json', 'pgg']);
});

it('keeps two tabs apart that began with the same project', {tags: ['thorough']}, async () => {
  const page = await quietPage();
  await chooseGroup(page, 'pgg');
  await reloaded(page); // it is saved by now
  const [twin] = await Promise.all([
    page.context().waitForEvent('page'),
    page.evaluate(() => {
      open(location.href); // copies this tab's session
    }),
  ]);
  await twin.getByRole('radiogroup', {name: 'Symmetry of the print'}).waitFor();
  expect(await groupOf(twin)).toBe('pgg');
  await chooseGroup(twin, 'cmm');
  await chooseGroup(page, 'p6m');
  await Promise.all([reloaded(twin), reloaded(page)]);
  expect([await groupOf(page), await groupOf(twin)]).toEqual(['p6m', 'cmm']);
});
