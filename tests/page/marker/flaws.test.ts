/** Flaws of the fabric without a pointer: added, moved, enlarged, removed, each step announced. */
import type {Locator, Page} from 'playwright-core';
import {expect, it} from 'vitest';

import type {LayPlan} from '@/model/result/marker-plan.js';
import {barriers} from '../../support/page/barriers.js';
import {button, saved, usePage} from '../../support/page/page.js';
import {layoutOf, laid, pane, panel, status} from '../../support/page/marker.js';

const openPage = usePage();

const rows = (page: Page): Locator => panel(page).locator('.flaws li');
const nameOf = (page: Page, number: number): Locator =>
  rows(page).getByRole('button', {name: new RegExp(`^Flaw ${number},`)});
const undoTitle = (page: Page): Promise<string | null> =>
  button(page, 'Undo').getAttribute('title');
const isFocused = (row: Locator): Promise<boolean> => row.evaluate((one) => one.matches(':focus'));

/** The announced position from the left and from the start, width and length. [cm] */
async function told(page: Page): Promise<readonly number[]> {
  const words =
    /^Flaw \d, ([\d.]+) cm from the left, ([\d.]+) cm from the start, ([\d.]+) cm wide, ([\d.]+) cm long$/;
  return (words.exec((await status(page)) ?? '') ?? []).slice(1).map(Number);
}

/** Returns whether all pieces of a layout are clear of a box. */
const clearOf = ({placements}: LayPlan, [x = 0, y = 0, w = 0, h = 0]: readonly number[]): boolean =>
  placements.every(({cut}) =>
    cut.every(([px, py]) => px < x || px > x + w || py < y || py > y + h),
  );

it(
  'adds a flaw in the middle of what is seen, moves it and makes it larger by keys, and says so',
  {tags: ['thorough']},
  async () => {
    const page = await layoutOf(await openPage());
    await panel(page).getByRole('button', {name: 'Add a flaw'}).focus();
    await page.keyboard.press('Enter');
    await expect.poll(() => rows(page).count()).toBe(1);
    await expect.poll(() => isFocused(nameOf(page, 1))).toBe(true);
    await expect.poll(() => told(page)).toHaveLength(4);
    const [left = 0, start = 0, width, length] = await told(page);
    expect([width, length]).toEqual([5, 5]);
    expect(left).toBeGreaterThan(40);
    expect(left).toBeLessThan(95);
    await expect.poll(() => pane(page).locator('.sheet .flaw.chosen').count()).toBe(1);
    await laid(page);
    await expect.poll(() => undoTitle(page)).toBe('Undo: flaw');

    await page.keyboard.press('ArrowLeft');
    await expect.poll(() => told(page)).toEqual([left - 1, start, 5, 5]);
    await laid(page);
    await page.keyboard.press('ArrowUp');
    await expect.poll(() => told(page)).toEqual([left - 1, start + 1, 5, 5]);
    await page.keyboard.press('Shift+ArrowRight');
    await page.keyboard.press('Shift+ArrowDown');
    await expect.poll(() => told(page)).toEqual([left - 1, start + 1, 6, 4]);
    await laid(page);
    const plan = JSON.parse(await saved(page, 'Save fabric layout (JSON)')) as LayPlan;
    expect(clearOf(plan, await told(page))).toBe(true);

    // changes before the next layout are one undo step
    for (let k = 0; k < 5 && (await rows(page).count()) > 0; k++)
      await button(page, 'Undo').click();
    await expect.poll(() => rows(page).count()).toBe(0);
    await button(page, 'Redo').click();
    await expect.poll(() => rows(page).count()).toBe(1);
    await expect.poll(() => pane(page).locator('.sheet .flaw').count()).toBe(1);
  },
);

it(
  'takes the place and size of a flaw by figures, removes it by Delete, and leaves the focus near',
  {tags: ['thorough']},
  async () => {
    const page = await layoutOf(await openPage());
    await pane(page).locator('.application').focus();
    await page.keyboard.press('Shift+X');
    await page.keyboard.press('ArrowRight'); // acts on the new flaw
    await expect.poll(() => told(page)).toHaveLength(4);
    const [left = 0] = await told(page);
    const figures = rows(page).getByRole('group', {name: /^Flaw 1/});
    const field = (name: string): Locator => figures.getByLabel(name);
    await expect
      .poll(async () => Number(await field('From the left edge (cm)').inputValue()))
      .toBeCloseTo(left, 1);
    for (const [name, value] of [
      ['From the left edge (cm)', '30'],
      ['From the start (cm)', '12.5'],
      ['Width (cm)', '8'],
      ['Length (cm)', '3'],
    ] as const) {
      await field(name).fill(value);
      await field(name).press('Enter');
      await expect.poll(() => status(page)).toContain(value);
    }
    await expect.poll(() => told(page)).toEqual([30, 12.5, 8, 3]);
    await field('From the left edge (cm)').fill('139');
    await field('From the left edge (cm)').press('Enter');
    await expect
      .poll(() => figures.getByRole('alert').textContent())
      .toMatch(/from 0 cm to 132 cm/);
    await laid(page);
    await panel(page).getByRole('button', {name: 'Add a flaw'}).click();
    await expect.poll(() => isFocused(nameOf(page, 2))).toBe(true);
    await page.keyboard.press('Delete');
    await expect.poll(() => status(page)).toBe('Flaw 2 is removed.');
    await expect.poll(() => isFocused(nameOf(page, 1))).toBe(true);
    await expect.poll(() => nameOf(page, 1).textContent()).toMatch(/30.* 12.5/);
    await page.keyboard.press('Delete');
    await expect.poll(() => rows(page).count()).toBe(0);
    await expect
      .poll(() => isFocused(panel(page).getByRole('button', {name: 'Add a flaw'})))
      .toBe(true);
    await laid(page);
  },
);

it.each([
  ['light', 1280],
  ['dark', 390],
] as const)(
  'keeps nobody out of the list of flaws in %s, %i pixels wide',
  {tags: ['thorough']},
  async (colorScheme, width) => {
    const page = await layoutOf(await openPage({colorScheme, viewport: {width, height: 800}}));
    await panel(page).getByRole('button', {name: 'Add a flaw'}).click();
    await laid(page);
    await expect.poll(() => rows(page).getByRole('group').count()).toBe(1);
    await panel(page).locator('.flaws').scrollIntoViewIfNeeded();
    expect(await barriers(page, ['minor', 'moderate', 'serious', 'critical'])).toEqual([]);
  },
);
