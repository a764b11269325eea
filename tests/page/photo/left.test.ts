/** The photo dialog, closed before its print is used, and its measurements. */
import type {Locator} from 'playwright-core';
import {beforeAll, expect, it, vi} from 'vitest';

import {usePage} from '../../support/page/page.js';
import {designOf} from '../../support/page/design.js';
import {dialogOf, found, give, measure, openSheet, patient, use} from '../../support/page/photo.js';
import {jpegOf} from '../../support/photo/files.js';
import {floralCase} from '../../support/photo/print-cases.js';

vi.setConfig({testTimeout: 240_000}); // a busy machine is slow at everything

const openPage = usePage();

let photograph: Buffer;

beforeAll(async () => {
  const size = [900, 700] as const;
  const {pixels} = await floralCase({name: 'floral', level: 'scan', seed: 11, size}, 'pmm');
  photograph = await jpegOf(pixels, 92);
}, 240_000);

const lengths = (dialog: Locator): Locator => dialog.getByLabel('measure (cm)');

it('is there again as it was left, until its print is taken', {tags: ['thorough']}, async () => {
  const page = await openPage();
  const dialog = await openSheet(page);
  await give(page, photograph);
  expect(await found(dialog)).toBe('Found: Mirrors both ways.');
  await measure(dialog, 80);
  await dialog.getByText(/One repeat is 8 cm × /).waitFor();
  await lengths(dialog).first().focus();
  await page.keyboard.press('Escape');
  await expect.poll(() => dialogOf(page).count()).toBe(0);
  const before = (await designOf(page)).print.title;
  await openSheet(page);
  // not analysed again: the result is there at once, with its undo steps
  await expect.poll(() => dialog.getByText('Found: Mirrors both ways.').count()).toBe(1);
  await expect.poll(() => lengths(dialog).first().inputValue()).toBe('80');
  await dialog.getByRole('button', {name: 'Undo'}).click();
  await dialog.getByText(/^Size unknown/).waitFor();
  await dialog.getByRole('button', {name: 'Redo'}).click();
  await dialog.getByRole('button', {name: 'Close'}).click();
  await expect.poll(() => dialogOf(page).count()).toBe(0);
  expect((await designOf(page)).print.title).toBe(before);
  await openSheet(page);
  await found(dialog);
  const isTurned = (): Promise<boolean> => dialog.getByText(/turned by -?90°/).isVisible();
  if (!(await isTurned())) await dialog.getByRole('button', {name: 'Turn by 90°'}).click();
  await expect.poll(isTurned).toBe(true);
  await use(page).click();
  await expect.poll(() => dialogOf(page).count(), patient).toBe(0);
  await page.getByText('Your own: meadow').waitFor();
  // the sides' directions differ from their names: arrows show them, and the names stay
  const sides = page.locator('sw-repeat-fields');
  const width = sides.getByRole('spinbutton', {name: 'Repeat width (cm)', exact: true});
  await expect.poll(() => width.inputValue()).toBe('8');
  await expect.poll(() => sides.getByText(/Repeat width \(cm\)\s[↑↓]/).count()).toBe(1);
  await expect.poll(() => sides.getByText(/Repeat height \(cm\)\s[←→]/).count()).toBe(1);
  // no unfinished photo remains after its print was used and saved
  await openSheet(page);
  await expect.poll(() => lengths(dialog).first().inputValue(), patient).toBe('80');
  await expect.poll(() => dialog.getByRole('button', {name: 'Undo'}).isDisabled()).toBe(true);
});

it(
  'says once which lengths disagree, and lets either be removed',
  {tags: ['thorough']},
  async () => {
    const page = await openPage();
    const dialog = await openSheet(page);
    await give(page, photograph);
    await found(dialog);
    await measure(dialog, 80);
    const said = await dialog.getByText(/^One repeat is 8 cm × /).innerText();
    const height = Number(/× ([\d.]+) cm/.exec(said)?.[1]);
    const second = lengths(dialog).nth(1);
    await second.fill(String(20 * height));
    await second.press('Enter');
    const alert = dialog.getByRole('alert');
    await alert.waitFor();
    await expect
      .poll(() => alert.innerText())
      .toMatch(
        /^Your measures disagree by (99|10[01]) %: with 8 cm one way, the photo shows .* not .* Both count until you remove one\.$/,
      );
    // the measured arrow is marked while its field has the focus
    const marked = page.locator('sw-photo-stage .arrow.measured');
    await expect.poll(() => marked.getAttribute('class')).toBe('arrow w2 measured');
    await lengths(dialog).first().focus();
    await expect.poll(() => marked.getAttribute('class')).toBe('arrow w1 measured');
    await dialog.getByLabel('Name').focus();
    await expect.poll(() => marked.count()).toBe(0);
    await dialog.getByRole('button', {name: /^Remove this measure: Repeats up/}).click();
    await expect.poll(() => alert.count()).toBe(0);
    await expect.poll(() => second.inputValue()).toBe('');
    await dialog.getByText(said).waitFor();
    await dialog.getByRole('button', {name: /^Remove this measure: Repeats across/}).click();
    await dialog.getByText(/^Size unknown/).waitFor();
  },
);
