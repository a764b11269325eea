/** Remedies that the page offers for an answer. */
import {expect, it} from 'vitest';

import {button, drawn, showSample, solved, usePage} from '../../support/page/page.js';
import {frames} from '../../support/page/waiting.js';

const openPage = usePage();

it(
  'says which seams stay off, and leaves out the gathers with one click, which undo takes back',
  {tags: ['thorough']},
  async () => {
    const page = await openPage();
    await solved(page);
    await showSample(page, 'gathered-skirt');
    await page.getByRole('heading', {name: /seams stay off$/}).waitFor();
    const remedy = page.getByRole('button', {
      name: /^Leave out the gathers: [\d.]+ mm → [\d.]+ mm$/,
    });
    const words = (await remedy.textContent({timeout: 60_000})) ?? '';
    await remedy.click();
    await solved(page);
    await page.getByRole('heading', {name: /seams stay off$/}).waitFor({state: 'detached'});
    const [, after = ''] = /→ ([\d.]+ mm)/.exec(words) ?? [];
    const headline = page.getByRole('heading', {name: /^On average the print misses by/});
    await expect.poll(() => headline.textContent()).toContain(`misses by ${after}`);
    await button(page, 'Undo').click();
    const heading = page.getByRole('heading', {name: /seams stay off$/});
    await heading.waitFor();
    await drawn(heading);
    const known = await remedy.count();
    expect(known).toBe(1); // no other search
  },
);

it('has a headline that no seam of the table contradicts, the same in every window', async () => {
  const page = await openPage();
  await solved(page);
  const seams = page.getByRole('table', {name: 'Seams', exact: true});
  const figures = async () => {
    await drawn(seams);
    const headline = await page
      .getByRole('heading', {name: /^On average the print misses by/})
      .textContent();
    const worst = await page.getByLabel('How well it meets', {exact: true}).textContent();
    const rows = await seams
      .locator('tbody tr')
      .evaluateAll((all) =>
        all.map((row) =>
          [...row.querySelectorAll('.number')].slice(1, 3).map((cell) => cell.textContent.trim()),
        ),
      );
    return {headline, worst: worst?.trim(), rows};
  };
  const wide = await figures();
  const number = (text = ''): number => Number(/([\d.]+) mm/.exec(text)?.[1]);
  const after = wide.rows.map(([, text]) => number(text));
  expect(Math.max(...after)).toBe(number(wide.worst));
  expect(Math.max(...after)).toBeGreaterThanOrEqual(number(wide.headline ?? ''));
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
    await status.filter({hasText: /^(Looking|[\d.]+ mm better so far)/}).waitFor();
    await button(page, 'Stop').click();
    await status.filter({hasText: /^(Nothing better was found\.|[\d.]+ mm better\.)$/}).waitFor();
    await expect
      .poll(() => page.getByRole('heading', {name: /^On average the print misses by/}).count())
      .toBe(1);
  },
);
