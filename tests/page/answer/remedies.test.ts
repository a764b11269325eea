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
  'looks for a better answer when asked, and until it is told to stop',
  {tags: ['thorough']},
  async () => {
    const page = await openPage();
    await solved(page);
    await button(page, 'Keep improving').click();
    const status = page.getByRole('status', {name: 'Improvement'});
    await status
      .filter({hasText: /^(Looking|The match is better so far|\d+ more seams? match(es)? so far)/})
      .waitFor();
    await button(page, 'Stop').click();
    await status
      .filter({
        hasText: /^(Nothing better was found|The match is better|\d+ more seams? match(es)?)\.$/,
      })
      .waitFor();
    await page.getByRole('heading', {name: /visible seams? match/}).waitFor();
  },
);
