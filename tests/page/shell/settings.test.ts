/** Settings for shape and alignment of the pieces, and for the page's appearance. */
import {expect, it} from 'vitest';

import {sampleOf} from '../../support/level.js';
import {button, usePage} from '../../support/page/page.js';
import {designOf} from '../../support/page/design.js';

const openPage = usePage();

const change = 'Outlines may change by (mm)';

it('takes several decisions at once for who starts', {tags: ['thorough']}, async () => {
  const page = await openPage({viewport: {width: 640, height: 480}});
  await button(page, 'Woven shirt').click();
  const {options, method} = await designOf(page);
  expect([options.maxChangeCm, options.grain?.default, method]).toEqual([0.4, 'on', 'best']);
  await expect.poll(() => button(page, 'Woven shirt').getAttribute('aria-pressed')).toBe('true');
  await expect.poll(() => page.getByLabel(change).inputValue()).toBe('4');
  await page.getByLabel('Grain for all pieces').selectOption('On the bias');
  await expect.poll(() => button(page, 'Woven shirt').getAttribute('aria-pressed')).toBe('false');
  expect((await designOf(page)).options.grain).toEqual({default: 'bias'});
});

it.each(sampleOf(1, ['-1', '21', '']))(
  'refuses to let pieces change by "%s" mm, and says so',
  {tags: ['thorough']},
  async (typed) => {
    const page = await openPage({viewport: {width: 640, height: 480}});
    const field = page.getByLabel(change);
    await field.waitFor();
    const before = await designOf(page);
    await field.fill(typed);
    await field.press('Enter');
    await page.getByText(/Enter a number from 0(\.0)? mm to 20 mm\./).waitFor();
    await expect.poll(() => field.getAttribute('aria-invalid')).toBe('true');
    expect(await designOf(page)).toEqual(before);
    await field.fill('7.5');
    await field.press('Enter');
    await expect.poll(() => field.getAttribute('aria-invalid')).toBeNull();
    expect((await designOf(page)).options.maxChangeCm).toBeCloseTo(0.75, 12);
  },
);

it('solves only when asked once that is switched off', {tags: ['thorough']}, async () => {
  const page = await openPage({viewport: {width: 640, height: 480}});
  const live = page.getByRole('switch', {name: 'Match after each change'});
  await expect.poll(() => live.getAttribute('aria-checked')).toBe('true');
  await live.press('Space');
  await expect.poll(() => live.getAttribute('aria-checked')).toBe('false');
  await page.getByLabel('Continuous print only').check();
  expect((await designOf(page)).options.continuousOnly).toBe(true);
  await page.getByText('Out of date. Choose Match print to update it.').waitFor();
});

it('speaks German, counts in inches and is dark, and is so again the next time', async () => {
  const page = await openPage({viewport: {width: 640, height: 480}});
  await button(page, 'Settings').press('Enter');
  await page.getByLabel('Units').selectOption('Inches');
  await page.getByLabel('Repeat width (in)').waitFor();
  await page.getByRole('combobox', {name: 'Colours'}).selectOption('Dark');
  await page.getByLabel('Language').selectOption('Deutsch');
  await page.getByLabel('Rapportbreite (in)').waitFor();
  await page.reload();
  await page.getByLabel('Rapportbreite (in)').waitFor();
  const root = page.locator('html');
  expect([await root.getAttribute('lang'), await root.getAttribute('data-theme')]).toEqual([
    'de',
    'dark',
  ]);
});

it(
  'opens its settings within a narrow window, and closes them on Escape',
  {tags: ['thorough']},
  async () => {
    const page = await openPage({viewport: {width: 390, height: 800}});
    await button(page, 'Settings').click();
    const panel = page.getByRole('group', {name: 'Settings'});
    const box = await panel.boundingBox();
    expect(box?.x).toBeGreaterThanOrEqual(0);
    expect((box?.x ?? 0) + (box?.width ?? 0)).toBeLessThanOrEqual(390);
    await page.keyboard.press('Escape');
    await expect.poll(() => panel.isVisible()).toBe(false);
  },
);
