/** The command palette, and the descriptions of undo steps. */
import type {Locator, Page} from 'playwright-core';
import {expect, it, vi} from 'vitest';

import {barriers} from '../../support/page/barriers.js';
import {askedSymmetries} from '@/model/design/design.js';
import {designOf} from '../../support/page/design.js';
import {button, solved, usePage} from '../../support/page/page.js';
import {sampleOf} from '../../support/level.js';

vi.setConfig({testTimeout: 180_000}); // a busy machine is slow at everything

const openPage = usePage();

const field = (page: Page): Locator => page.getByRole('combobox', {name: 'Look for a command'});
const options = (page: Page): Locator =>
  page.getByRole('listbox', {name: 'Commands'}).getByRole('option');
const active = (page: Page): Locator =>
  page.getByRole('listbox', {name: 'Commands'}).getByRole('option', {selected: true});
const pattern = (page: Page): Locator => page.getByRole('application', {name: 'Pattern'});

/** Searches for a command with the keyboard alone, and runs the first match. */
async function command(page: Page, words: string, title: string): Promise<void> {
  await page.keyboard.press('Control+k');
  await field(page).waitFor();
  await page.keyboard.type(words);
  await active(page).filter({hasText: title}).waitFor();
  await page.keyboard.press('Enter');
  await field(page).waitFor({state: 'detached'});
}

it('opens a sample by its name', {tags: ['thorough']}, async () => {
  const page = await openPage();
  await solved(page);
  await command(page, 'garment six gore', 'Garment: Six-gore skirt');
  await expect
    .poll(async () => (await designOf(page)).garment.sample?.style, {timeout: 20_000})
    .toBe('six-gore-skirt');
});

it(
  'chooses a print by its name, names it in undo, and takes it back',
  {tags: ['thorough']},
  async () => {
    const page = await openPage();
    await solved(page);
    const before = await designOf(page);
    await command(page, 'fabric majol', 'Print: Majolica');
    expect((await designOf(page)).print).toMatchObject({group: 'p4m', title: 'Majolica'});
    const undo = button(page, 'Undo');
    await expect.poll(() => undo.getAttribute('title')).toBe('Undo: print, Majolica');
    await command(page, 'undo majolica', 'Undo: print, Majolica');
    expect(await designOf(page)).toEqual(before);
    await expect
      .poll(() => button(page, 'Redo').getAttribute('title'))
      .toBe('Redo: print, Majolica');
  },
);

it(
  'takes a print that keeps no symmetry, says so, and takes it back with them',
  {tags: ['thorough']},
  async () => {
    const page = await openPage();
    await solved(page);
    await command(page, 'accept', 'Accept all symmetries');
    const before = await designOf(page);
    expect(askedSymmetries(before)).not.toEqual([]);
    const notice = page.getByRole('status').filter({hasText: /^\s*Meadow walk has no mirrors/});
    await command(page, 'meadow', 'Print: Meadow walk');
    await notice.waitFor();
    const after = await designOf(page);
    expect(after.print.group).toBe('p1');
    expect(askedSymmetries(after)).toEqual([]);
    await notice.getByRole('button', {name: 'Undo'}).click();
    expect(await designOf(page)).toEqual(before);
  },
);

it(
  'gives the focus back on Escape, and is closed by its own key as well',
  {tags: ['thorough']},
  async () => {
    const page = await openPage();
    await solved(page);
    await pattern(page).focus();
    const isFocused = (): Promise<boolean> =>
      pattern(page).evaluate((element) => element.matches(':focus'));
    await page.keyboard.press('Control+k');
    await field(page).waitFor();
    expect(await field(page).evaluate((element) => element.matches(':focus'))).toBe(true);
    await page.keyboard.press('Escape');
    await field(page).waitFor({state: 'detached'});
    expect(await isFocused()).toBe(true);
    await page.keyboard.press('Control+k');
    await field(page).waitFor();
    await page.keyboard.press('Control+k');
    await field(page).waitFor({state: 'detached'});
    expect(await isFocused()).toBe(true);
  },
);

it('is walked by arrow keys, says how many there are, and why one cannot be carried out', async () => {
  const page = await openPage();
  await solved(page);
  await button(page, 'Commands').click();
  await field(page).fill('turn selected');
  await expect.poll(() => options(page).count()).toBe(1);
  await page.getByText('1 command', {exact: true}).waitFor();
  await expect.poll(() => active(page).getAttribute('aria-disabled')).toBe('true');
  await expect.poll(() => active(page).textContent()).toContain('select a piece first');
  await page.keyboard.press('Enter');
  await expect.poll(() => field(page).isVisible()).toBe(true);
  await field(page).fill('');
  await expect.poll(() => options(page).count()).toBeGreaterThan(60);
  const [first, second] = await options(page).allTextContents();
  await expect.poll(() => active(page).textContent()).toBe(first);
  await page.keyboard.press('ArrowDown');
  await expect.poll(() => active(page).textContent()).toBe(second);
  const id = await field(page).getAttribute('aria-activedescendant');
  await expect.poll(() => active(page).getAttribute('id')).toBe(id);
  await page.keyboard.press('ArrowUp');
  await page.keyboard.press('ArrowUp');
  await expect
    .poll(() => active(page).textContent())
    .toBe((await options(page).allTextContents()).at(-1));
  await field(page).fill('no such thing');
  await page.getByText('No command found.').waitFor();
});

it(
  'turns a piece, hands a tool over to the keys of the pattern, and changes the language',
  {tags: ['thorough']},
  async () => {
    const page = await openPage();
    await solved(page);
    await command(page, 'rotate back', 'Turn Back by 90°');
    expect((await designOf(page)).options.grain?.pieces).toEqual({back: 'across'});
    await expect
      .poll(() => button(page, 'Undo').first().getAttribute('title'))
      .toBe('Undo: turn Back');
    await page.getByRole('status').getByRole('button', {name: 'Undo'}).click();
    await page.getByText('Undone: turn Back.').waitFor();
    await command(page, 'move print', 'Move print');
    await expect.poll(() => button(page, 'Move print').getAttribute('aria-pressed')).toBe('true');
    expect(await pattern(page).evaluate((element) => element.matches(':focus'))).toBe(true);
    await command(page, 'deutsch', 'Language: Deutsch');
    await page.getByRole('button', {name: 'Befehle'}).waitFor();
  },
);

it.each(
  sampleOf(1, [
    ['dark', 390],
    ['light', 1280],
  ] as const),
)('is accessible in %s, %i pixels wide', {tags: ['thorough']}, async (colorScheme, width) => {
  const page = await openPage({colorScheme, viewport: {width, height: 800}});
  await solved(page);
  if (width > 640) await button(page, 'Commands').click();
  else await page.keyboard.press('Control+k'); // a phone's head has no room for the button
  await field(page).waitFor();
  expect(await barriers(page, ['minor', 'moderate', 'serious', 'critical'])).toEqual([]);
  if (width > 640) return;
  const sizes = await options(page).evaluateAll((all) =>
    all.map((one) => one.getBoundingClientRect().height),
  );
  expect(Math.min(...sizes)).toBeGreaterThanOrEqual(44);
});

it(
  'finds the views, and with the garment worn what that can be asked for, with the keys of it',
  {tags: ['thorough']},
  async () => {
    const page = await openPage();
    await solved(page);
    await command(page, 'shown garment', 'Shown as: Garment');
    const worn = page.locator('sw-drape-pane');
    const status = worn.locator('[role=status]');
    await expect
      .poll(() => status.textContent(), {timeout: 120_000})
      .toContain('Three-quarter view.');
    await command(page, 'seen back', 'Seen from: Back');
    await expect.poll(() => status.textContent(), {timeout: 20_000}).toContain('Back view.');
    await command(page, 'jersey', 'Fabric: Jersey');
    expect((await designOf(page)).fabric).toBe('jersey');
    const garment = page.getByRole('application', {name: 'Garment, worn'});
    await garment.focus();
    const toggled = (name: string): Promise<string | null> =>
      worn.getByRole('button', {name, exact: true}).getAttribute('aria-pressed');
    for (const [key, name, is] of [
      ['s', 'Seams', 'false'],
      ['b', 'Before and after', 'true'],
      ['d', 'Form', 'false'],
      ['t', 'Turntable', 'true'],
    ] as const) {
      await page.keyboard.press(key);
      await expect.poll(() => toggled(name)).toBe(is);
    }
    await page.keyboard.press('t');
    await page.keyboard.press('?');
    const map = page.getByRole('region', {name: 'Keys'});
    await map.getByRole('heading', {name: 'Garment'}).waitFor();
    await expect.poll(() => map.getByText('Seen from: Three-quarter').isVisible()).toBe(true);
    await page.keyboard.press('Escape');
    await page.keyboard.press('v');
    await expect.poll(() => pattern(page).isVisible()).toBe(true);
    await expect.poll(() => worn.count()).toBe(0);
    await page.keyboard.press('v');
    await expect.poll(() => pattern(page).isVisible()).toBe(true);
    await expect.poll(() => garment.isVisible()).toBe(true);
  },
);
