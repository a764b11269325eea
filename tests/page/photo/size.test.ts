/** Size of a print in a photo from a coin on the fabric, and its colours from a white object. */
import type {Locator} from 'playwright-core';
import {beforeAll, expect, it, vi} from 'vitest';

import {usePage} from '../../support/page/page.js';
import {designOf} from '../../support/page/design.js';
import {dialogOf, found, give, measure, openSheet, patient, use} from '../../support/page/photo.js';
import {jpegOf} from '../../support/photo/files.js';
import {card, coin, withThing} from '../../support/photo/known-objects.js';
import {floralCase} from '../../support/photo/print-cases.js';

vi.setConfig({testTimeout: 240_000}); // a busy machine is slow at everything

const openPage = usePage();

const size = [900, 700] as const;
const coinAt = [330, 250] as const;
let photograph: Buffer;
/** Width of the repeat. [cm] */
let repeat: number;

beforeAll(async () => {
  const {truth, pixels} = await floralCase({name: 'coin', level: 'normal', seed: 5, size}, 'p4');
  if (truth.group === null) throw new Error('A print has a group.');
  repeat = Math.hypot(...truth.w1);
  const one = withThing(pixels, truth, coin(2.325), {at: coinAt});
  const both = withThing(one, truth, card(8.56, 5.398), {at: [600, 420], turn: 0.4});
  photograph = await jpegOf(both, 92);
}, 240_000);

/** The repeat's size in the dialog. [cm] */
async function said(dialog: Locator): Promise<number> {
  const text = await dialog.getByText(/One repeat is /).innerText();
  return Number(/is ([\d.]+) cm/.exec(text)?.[1]);
}

it(
  'follows from a coin and from a card, is undone, and is refused where there is none',
  {tags: ['thorough']},
  async () => {
    const page = await openPage();
    const dialog = await openSheet(page);
    await give(page, photograph);
    expect(await found(dialog)).toBe('Found: Quarter turns.');
    await dialog.getByLabel('Coin or card', {exact: true}).check();
    const tap = async (x: number, y: number): Promise<void> => {
      const box = await page.locator('sw-photo-stage .frame').boundingBox();
      if (!box) throw new Error('There is no photograph.');
      await page.mouse.click(box.x + (x * box.width) / size[0], box.y + (y * box.height) / size[1]);
    };
    await tap(coinAt[0] + 5, coinAt[1] - 4);
    await dialog
      .getByText(/Measured by the red outline, accurate to about 1(\.\d)? %\./)
      .waitFor(patient);
    expect(Math.abs((await said(dialog)) / repeat - 1)).toBeLessThan(0.02);
    await expect.poll(() => page.locator('sw-photo-stage .outline').count()).toBe(1);
    const undo = dialog.getByRole('button', {name: 'Undo'});
    await undo.click();
    await dialog.getByText(/^Size unknown/).waitFor();
    await expect.poll(() => page.locator('sw-photo-stage .outline').count()).toBe(0);
    await tap(120, 640);
    await dialog.getByText(/^The object was not found there/).waitFor(patient);
    await expect.poll(() => undo.isEnabled()).toBe(false);
    await dialog.locator('sw-photo-measures select').selectOption('card');
    await tap(606, 412);
    await dialog.getByText(/Measured by the red outline/).waitFor(patient);
    expect(Math.abs((await said(dialog)) / repeat - 1)).toBeLessThan(0.02);
    await use(page).click();
    await expect.poll(() => dialogOf(page).count(), patient).toBe(0);
    const {print} = await designOf(page);
    expect(print.unscaled).toBeUndefined();
    expect(Math.abs(print.size.width / repeat - 1)).toBeLessThan(0.01);
  },
);

it(
  'tells how far the search for a coin is, and is given up at once',
  {tags: ['thorough']},
  async () => {
    const page = await openPage();
    const dialog = await openSheet(page);
    await give(page, photograph);
    await found(dialog);
    await measure(dialog, 80);
    const before = await said(dialog);
    await dialog.getByLabel('Coin or card', {exact: true}).check();
    const look = dialog.getByRole('button', {name: 'Look for it at the ring'});
    // a single call, as the solver could finish between separate ones
    const seen = await look.evaluate(async (button: HTMLButtonElement) => {
      const root = button.getRootNode() as ShadowRoot;
      const host = root.host as Element & {readonly updateComplete: Promise<unknown>};
      await host.updateComplete;
      button.click();
      await host.updateComplete;
      const note = root.querySelector('.note');
      const bar = note?.querySelector('progress');
      const told = {
        ...{role: note?.role, text: note?.querySelector('p')?.textContent},
        ...{label: bar?.ariaLabel, value: bar?.value, isBusy: button.disabled},
      };
      note?.querySelector('button')?.click();
      await host.updateComplete;
      return {
        ...told,
        isLeft: !root.querySelector('.note'),
        isFocused: root.activeElement === button,
      };
    });
    expect(seen).toEqual({
      ...{
        role: 'status',
        text: expect.stringMatching(/^Looking for the outline, 0\s?%$/) as string,
      },
      ...{label: 'Looking for the outline', value: 0, isBusy: true, isLeft: true, isFocused: true},
    });
    await expect.poll(() => said(dialog)).toBe(before);
    await expect.poll(() => page.locator('sw-photo-stage .outline').count()).toBe(0);
    await expect.poll(() => look.isEnabled()).toBe(true);
    // the next search does not wait for it
    await look.click();
    await dialog.getByText(/^(The object was not found there|Measured by)/).waitFor(patient);
  },
);

it('is measured and made white by keys alone', {tags: ['thorough']}, async () => {
  const page = await openPage();
  const dialog = await openSheet(page);
  await give(page, photograph);
  await found(dialog);
  await dialog.getByLabel('Coin or card', {exact: true}).focus();
  await page.keyboard.press('Space');
  const ring = dialog.getByRole('button', {name: 'Middle of the coin or card'});
  await ring.focus();
  // moves from the middle of the image to the coin
  for (let k = 0; k < 12; k++) await page.keyboard.press('Shift+ArrowLeft');
  for (let k = 0; k < 10; k++) await page.keyboard.press('Shift+ArrowUp');
  await page.keyboard.press('ArrowLeft');
  await page.keyboard.press('Enter');
  await dialog.getByText(/Measured by the red outline/).waitFor(patient);
  expect(Math.abs((await said(dialog)) / repeat - 1)).toBeLessThan(0.02);
  await dialog.getByRole('button', {name: 'White balance'}).focus();
  await page.keyboard.press('Enter');
  await dialog.getByRole('button', {name: 'Something white'}).focus();
  await page.keyboard.press('Enter');
  await dialog.getByRole('button', {name: 'Colours as taken'}).waitFor();
  await expect.poll(() => dialog.getByRole('button', {name: 'Something white'}).count()).toBe(0);
  await dialog.getByRole('button', {name: 'Undo'}).click();
  await expect.poll(() => dialog.getByRole('button', {name: 'Colours as taken'}).count()).toBe(0);
});

it(
  'shows on the photograph, too, where a symmetry that is chosen breaks',
  {tags: ['thorough']},
  async () => {
    const page = await openPage();
    const dialog = await openSheet(page);
    await give(page, photograph);
    await found(dialog);
    const broken = () => page.locator('sw-photo-stage .broken').getAttribute('d');
    await expect.poll(broken).toBe('');
    await dialog.getByText(/^Symmetry: /).click();
    await dialog.getByRole('radio', {name: 'Mirrors like a square, has not'}).check();
    await dialog.getByText('Differences from “Mirrors like a square”').waitFor(patient);
    await expect.poll(async () => (await broken())?.split('Z').length ?? 0).toBeGreaterThan(100);
    await dialog.getByLabel('Differences from the symmetry').uncheck();
    await expect.poll(broken).toBe('');
  },
);
