/** Fabric lengths in the interface: no figure contradicts the ones beside it. */
import type {Page} from 'playwright-core';
import {expect, it} from 'vitest';

import type {LayPlan} from '@/model/result/marker-plan.js';
import {button, saved, usePage} from '../../support/page/page.js';
import {
  bought,
  layoutOf,
  facts,
  laid,
  layTwice,
  pane,
  panel,
  rowOf,
} from '../../support/page/marker.js';

const openPage = usePage();

const caption = (page: Page): Promise<string> => panel(page).locator('.widths caption').innerText();
const savedPlan = async (page: Page): Promise<LayPlan> =>
  JSON.parse(await saved(page, 'Save fabric layout (JSON)')) as LayPlan;

it(
  'tells the lengths on other widths as those of all pieces packed anew while some are off the fabric or moved',
  {tags: ['thorough']},
  async () => {
    const page = await layoutOf(await openPage());
    await expect.poll(() => panel(page).locator('.widths tbody tr').count()).toBe(6);
    expect((await caption(page)).trim()).toBe('Other widths');
    const present = panel(page).locator('.widths .present .number');
    const packed = await present.innerText();
    const [used] = /[\d.]+(?= cm long)/.exec(await facts(page)) ?? ['0'];
    expect(packed).toBe(`${Math.ceil(Number(used) - 0.01)} cm`);
    expect((await savedPlan(page)).widths).toHaveLength(6);

    await rowOf(page, 'Sleeve left').focus();
    await page.keyboard.press('Delete');
    await expect.poll(() => bought(page)).toBe('1 piece does not lie yet');
    await expect.poll(() => caption(page)).toMatch(/Lengths for a new layout of all pieces$/);
    await expect.poll(() => present.innerText()).toBe(packed);
    // files contain only the length of the placed pieces
    const partial = await savedPlan(page);
    expect(partial).toMatchObject({widths: [], cheaper: [], phases: [{lengthCm: null}]});
    expect(partial.notes.join()).not.toMatch(/where the print starts/);
    const drawn = await saved(page, 'Save fabric layout (SVG)');
    expect(drawn).not.toMatch(/Other fabric|may start elsewhere/);

    await button(page, 'Undo').click();
    await expect.poll(async () => (await caption(page)).trim()).toBe('Other widths');
    await rowOf(page, 'Front').focus();
    await page.keyboard.press('ArrowUp');
    await expect.poll(() => facts(page)).toContain('Moved by hand');
    await expect.poll(() => caption(page)).toMatch(/packed anew$/);
    const moved = await savedPlan(page);
    expect(moved.phases).toEqual([{phaseCm: moved.printOrigin?.[0], lengthCm: moved.lengthCm}]);

    await rowOf(page, 'Front').focus();
    await page.keyboard.press('p');
    await pane(page).getByRole('button', {name: 'Pack the rest'}).click();
    await laid(page);
    // layouts of other widths ignore pins, which are meaningless there
    await expect.poll(() => caption(page)).toMatch(/packed anew with none pinned$/);
    await expect.poll(() => present.innerText()).toBe(packed);
    await expect.poll(async () => (await savedPlan(page)).widths).toEqual([]);
  },
);

it(
  'counts the garments that are laid when their number is taken back',
  {tags: ['thorough']},
  async () => {
    const page = await layoutOf(await openPage());
    const before = await bought(page);
    await layTwice(page);
    await button(page, 'Undo').click();
    await expect.poll(() => pane(page).locator('.piece').count()).toBe(4);
    await expect.poll(() => bought(page)).toBe(before);
    await expect.poll(() => panel(page).locator('.pieces tbody tr').count()).toBe(4);
  },
);
