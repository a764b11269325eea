/** The page for users of a screen reader or without a pointer. */
import type {Locator, Page} from 'playwright-core';
import {describe, expect, it, vi} from 'vitest';

import {barriers} from '../../support/page/barriers.js';
import {designOf} from '../../support/page/design.js';
import {button, drawn, showSample, solved, usePage} from '../../support/page/page.js';
import {clickPiece, clickSeam, middleOfPiece} from '../../support/page/pattern.js';
import {sampleOf} from '../../support/level.js';

vi.setConfig({testTimeout: 180_000}); // a busy machine is slow at everything

const openPage = usePage();
describe.each(sampleOf(1, ['light', 'dark'] as const))('in %s colours', (colorScheme) => {
  it('keeps nobody out of the garment, its lens, a tool, or the settings', async () => {
    const page = await openPage({colorScheme});
    await showSample(page, 'raglan');
    expect(await barriers(page)).toEqual([]);
    await clickSeam(page, 0, 'a');
    await page.getByRole('group', {name: 'Close-up of a seam'}).waitFor();
    expect(await barriers(page)).toEqual([]);
    await button(page, 'Symmetric pair').click();
    await clickPiece(page, 'front_left');
    expect(await barriers(page)).toEqual([]);
    await button(page, 'Settings').click();
    await page.getByRole('group', {name: 'Settings'}).waitFor();
    expect(await barriers(page)).toEqual([]);
  });
});

it(
  'shows the commands on a small screen, too, by a button as large as a finger',
  {tags: ['thorough']},
  async () => {
    const page = await openPage({viewport: {width: 390, height: 844}, hasTouch: true});
    await solved(page);
    const help = button(page, 'Commands');
    const {x, width, height} = (await help.boundingBox()) ?? {x: 0, width: 0, height: 0};
    expect(Math.min(width, height)).toBeGreaterThanOrEqual(44);
    expect(x + width).toBeLessThanOrEqual(390);
    await help.tap();
    await page.getByRole('listbox', {name: 'Commands'}).waitFor();
  },
);

it('keeps nobody out on a small screen', {tags: ['thorough']}, async () => {
  const page = await openPage({viewport: {width: 390, height: 844}});
  await solved(page);
  expect(await barriers(page)).toEqual([]);
});

const pattern = (page: Page): Locator => page.getByRole('application', {name: 'Pattern'});

/** A screen reader's text for the selected part of the pattern. */
async function spoken(page: Page): Promise<string> {
  await drawn(pattern(page));
  return pattern(page).evaluate((element) => {
    const id = element.getAttribute('aria-activedescendant');
    const root = element.getRootNode() as ShadowRoot;
    return (id && root.getElementById(id)?.textContent) ?? '';
  });
}

const tabTo = async (page: Page, wanted: Locator): Promise<void> => {
  for (let k = 0; k < 80; k++) {
    await page.keyboard.press('Tab');
    if (await wanted.evaluate((element) => element.matches(':focus'))) return;
  }
  throw new Error('Tab does not lead there.');
};

const press = async (page: Page, ...keys: readonly string[]): Promise<void> => {
  for (const key of keys) await page.keyboard.press(key);
};

it('is walked by keys alone, from pieces to seams and across to their twins', async () => {
  const page = await openPage();
  await solved(page);
  await tabTo(page, pattern(page));
  expect(await spoken(page)).toBe('');
  await press(page, 'ArrowRight');
  const first = await spoken(page);
  expect(first).toMatch(/^.+, \d+ seams?$/);
  await press(page, 'ArrowRight');
  const second = await spoken(page);
  expect(second).not.toBe(first);
  await press(page, 'ArrowLeft'); // may reach a third piece where pieces overlap
  expect(await spoken(page)).not.toBe(second);
  const third = await spoken(page);
  await press(page, 'Enter');
  const seam = await spoken(page);
  // includes the reason if it does not match
  expect(seam).toMatch(
    /^.+, [\d.]+ cm, mismatch [\d.]+ mm, (print mirrored|print continues|not counted)(, .+)?$/,
  );
  await press(page, 'ArrowRight');
  expect(await spoken(page)).not.toBe(seam);
  await press(page, 'ArrowLeft', 't');
  expect(await spoken(page)).toBe(seam); // the same seam, of the other piece
  await press(page, 'Escape');
  const other = await spoken(page);
  expect(other).toMatch(/^.+, \d+ seams?$/);
  expect(other).not.toBe(third);
  await press(page, 'Escape');
  expect(await spoken(page)).toBe('');
});

/** Selects pieces with the arrow keys until one has this name. */
async function walkTo(page: Page, piece: RegExp): Promise<void> {
  for (const key of ['ArrowRight', 'ArrowDown', 'ArrowLeft', 'ArrowUp']) {
    for (let k = 0; k < 8; k++) {
      if (piece.test(await spoken(page))) return;
      await press(page, key);
    }
  }
  expect(await spoken(page)).toMatch(piece);
}

it('makes a pair symmetric by keys alone, and takes that back', {tags: ['thorough']}, async () => {
  const page = await openPage();
  await showSample(page, 'raglan');
  await pattern(page).focus();
  const hint = page.getByRole('status', {name: 'What to do next'});
  await press(page, 'p', 'ArrowRight');
  await walkTo(page, /^front.*left/i);
  await press(page, ' ');
  await hint.filter({hasText: /^Now click the mirrored piece/}).waitFor();
  await walkTo(page, /^front.*right/i);
  await press(page, ' ');
  await hint.filter({hasText: /pieces are mirror images; they differ by at most/}).waitFor();
  await press(page, 'Enter');
  expect((await designOf(page)).symmetry).toMatchObject([
    {kind: 'pair', pieces: ['front_left', 'front_right']},
  ]);
  await solved(page);
  await press(page, 'Control+z');
  expect((await designOf(page)).symmetry).toBe('none');
  await press(page, 'Control+Shift+z');
  expect((await designOf(page)).symmetry).toHaveLength(1);
});

it(
  'moves a print by keys alone, and says that its piece is pinned',
  {tags: ['thorough']},
  async () => {
    const page = await openPage();
    await solved(page);
    await pattern(page).focus();
    await press(page, 'ArrowRight');
    const name = (await spoken(page)).replace(/, \d+ seams?$/, '');
    await press(page, 'm', 'ArrowRight', 'Shift+ArrowUp');
    const {pins = {}} = (await designOf(page)).options;
    expect(Object.keys(pins).length).toBe(1);
    await solved(page);
    const row = page.getByRole('table', {name: 'Pieces', exact: true}).getByRole('row', {name});
    await row.filter({hasText: 'Pinned'}).waitFor();
    await press(page, 'Control+z');
    expect((await designOf(page)).options.pins).toBeUndefined();
  },
);

it('takes a drag that rests on its way back in one step', {tags: ['thorough']}, async () => {
  const page = await openPage();
  await solved(page);
  await button(page, 'Move print').click();
  const before = await designOf(page);
  const [x, y] = await middleOfPiece(page, 'back');
  await page.clock.install();
  await page.mouse.move(x, y);
  await page.mouse.down();
  await page.mouse.move(x + 10, y);
  await page.clock.fastForward(1300); // longer than changes are grouped
  await page.mouse.move(x + 10, y + 10);
  await page.mouse.up();
  expect((await designOf(page)).options.pins).toBeDefined();
  await button(page, 'Undo').click();
  expect(await designOf(page)).toEqual(before);
});

it('chooses a group by arrow keys', {tags: ['thorough']}, async () => {
  const page = await openPage();
  await solved(page);
  const chosen = page
    .getByRole('radiogroup', {name: 'Symmetry of the print'})
    .getByRole('radio', {checked: true});
  await tabTo(page, chosen);
  await press(page, 'ArrowRight');
  expect((await designOf(page)).print.group).toBe('pmm');
  await solved(page);
});

it('shows and hides the map of keys from anywhere', {tags: ['thorough']}, async () => {
  const page = await openPage();
  await solved(page);
  const map = page.getByRole('region', {name: 'Keys', exact: true});
  await expect.poll(() => map.count()).toBe(0);
  await press(page, '?');
  await map.waitFor();
  await press(page, '?');
  await map.waitFor({state: 'hidden'});
  await pattern(page).focus();
  await press(page, 'ArrowRight', '?');
  await map.waitFor();
  await press(page, 'Escape');
  await map.waitFor({state: 'hidden'});
  expect(await spoken(page)).not.toBe(''); // Escape closes one thing at a time
  expect(await pattern(page).evaluate((element) => element.matches(':focus'))).toBe(true);
});
