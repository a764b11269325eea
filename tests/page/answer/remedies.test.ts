/** Remedies that the page offers for an answer. */
import {expect, it} from 'vitest';

import {button, drawn, showSample, solved, usePage} from '../../support/page/page.js';
import {frames} from '../../support/page/waiting.js';

const openPage = usePage();

it(
  'folds gathers away, and offers remedies that undo takes back',
  {tags: ['thorough']},
  async () => {
    const page = await openPage();
    await solved(page);
    await showSample(page, 'gathered-skirt');
    await solved(page);
    const result = page.getByRole('status', {name: 'Result', exact: true});
    await expect.poll(() => result.innerText()).toMatch(/visible seams? match/);
    const seams = page.getByRole('table', {name: 'Seams', exact: true});
    await seams.getByRole('button', {name: /^\d+ others: .*gathers/}).waitFor();
    const before = await result.innerText();
    const remedy = page
      .getByRole('status', {name: 'Changes that help'})
      .getByRole('button')
      .or(seams.locator('.why button'))
      .first();
    await remedy.click({timeout: 60_000});
    await solved(page);
    await button(page, 'Undo').click();
    await expect.poll(() => result.innerText()).toBe(before);
  },
);

it('has a headline that the list of seams agrees with, the same in every window', async () => {
  const page = await openPage();
  await solved(page);
  const result = page.getByRole('status', {name: 'Result', exact: true});
  const seams = page.getByRole('table', {name: 'Seams', exact: true});
  const figures = async () => {
    await drawn(seams);
    return {
      headline: await result.textContent(),
      rows: await seams.locator('tbody tr').allTextContents(),
    };
  };
  const wide = await figures();
  expect(wide.headline).toMatch(/\d/);
  await page.setViewportSize({width: 2200, height: 900});
  await frames(page);
  expect(await figures()).toEqual(wide);
});

it(
  'compares sizes of the print in idle time; the best is one click away, and so is the way back',
  {tags: ['thorough']},
  async () => {
    const query = '?garment=garments/asymmetric-dress-m.json&print=prints/p1.json';
    const page = await openPage({query, searches: true});
    await solved(page);
    const title = page.getByRole('heading', {name: /^\d+ of 9 visible seams? match/});
    const before = await title.innerText();
    const use = page.getByRole('button', {name: /^Use \d+ %$/});
    await use.waitFor({timeout: 60_000});
    expect(await title.innerText()).toBe(before);
    await page.getByRole('img', {name: 'Matching seams by print size'}).waitFor();
    await use.click();
    await expect.poll(() => title.innerText()).not.toBe(before);
    await button(page, 'Undo').click();
    await expect.poll(() => title.innerText()).toBe(before);
  },
);
