/** Photos of prints on all kinds of lattices, added in different ways. */
import type {Locator} from 'playwright-core';
import {expect, it, vi} from 'vitest';

import {latticeVectors} from '@/model/print/repeat.js';
import type {GroupName} from '@/model/print/repeating-print.js';
import {solved, usePage} from '../../support/page/page.js';
import {print as english} from '@/texts/en/print.js';
import {designOf} from '../../support/page/design.js';
import {
  bring,
  dialogOf,
  found,
  measure,
  openSheet,
  patient,
  use,
} from '../../support/page/photo.js';
import {jpegOf} from '../../support/photo/files.js';
import {floralCase} from '../../support/photo/print-cases.js';

vi.setConfig({testTimeout: 300_000}); // a busy machine is slow at everything

const openPage = usePage();

it.each([
  ['cmm', 33],
  ['p31m', 8],
] as const)(
  'is a print of group %s as the fabric has it, pasted',
  {tags: ['thorough']},
  async (group: GroupName, seed) => {
    const {truth, pixels} = await floralCase(
      {name: group, level: 'normal', seed, size: [800, 640]},
      group,
    );
    if (truth.group === null) throw new Error('A print has a group.');
    const long = Math.hypot(...truth.w1);
    const page = await openPage();
    const dialog = await openSheet(page);
    await expect
      .poll(() => page.locator('sw-photo input[capture=environment][accept="image/*"]').count())
      .toBe(1);
    await bring(page, await jpegOf(pixels, 92), `${group}.jpg`, 'paste');
    expect(await found(dialog)).toBe(`Found: ${english.print.kinds[group]}.`);
    await measure(dialog, 10 * long);
    await dialog.getByText(/One repeat is /).waitFor();
    await use(page).click();
    await expect.poll(() => dialogOf(page).count(), patient).toBe(0);
    const {print} = await designOf(page);
    expect(print).toMatchObject({group, title: group, cell: 'rectangular'});
    const [w1, w2] = latticeVectors(group, print.size, 0, print.cell);
    expect(Math.hypot(...w1) / long).toBeCloseTo(1, 2);
    expect(Math.hypot(...w2) / Math.hypot(...truth.w2)).toBeCloseTo(1, 2);
    const cosine = ([ax, ay]: readonly number[], [bx, by]: readonly number[]): number =>
      Math.abs((ax ?? 0) * (bx ?? 0) + (ay ?? 0) * (by ?? 0)) / long ** 2;
    expect(cosine(w1, w2)).toBeCloseTo(cosine(truth.w1, truth.w2), 1);
    await solved(page);
  },
);

/** Makes the dialog's result uncertain. */
const makeUncertain = (dialog: Locator): Promise<void> =>
  dialog.evaluate((element) => {
    const host = (element.getRootNode() as ShadowRoot).host as unknown as {
      session: {
        step: {reading: {map: {homography: number[]}}};
        resume: (history: object) => void;
      };
    };
    const {step} = host.session;
    const {homography} = step.reading.map;
    const twice = homography.map((value, k) => (k % 3 === 0 ? 2 * value : value));
    const {reading} = step;
    const others = [{...reading.map, homography: twice}];
    const present = {...step, reading: {...reading, confidence: 'uncertain', others}};
    host.session.resume({past: [], present, future: []});
  });

it('is of another lattice when somebody says so', {tags: ['thorough']}, async () => {
  const {pixels} = await floralCase({name: 'pm', level: 'scan', seed: 3, size: [800, 640]}, 'pm');
  const page = await openPage();
  const dialog = await openSheet(page);
  await bring(page, await jpegOf(pixels, 92), 'pm.jpg');
  await found(dialog);
  const lines = async (): Promise<number> =>
    (await page.locator('sw-photo-stage .cells').getAttribute('d'))?.split('M').length ?? 0;
  const before = await lines();
  await makeUncertain(dialog);
  await dialog.getByText(/^No repeat is certain/).waitFor();
  // it needs confirmation by its button; Enter does nothing
  const although = dialog.getByRole('button', {name: 'Use it anyway'});
  await although.waitFor();
  await expect.poll(() => use(page).count()).toBe(0);
  await dialog.getByText(/^It is uncertain that this is the print’s repeat/).waitFor();
  await dialog.getByRole('heading', {name: 'Photo of your fabric'}).click();
  await page.keyboard.press('Enter');
  await expect.poll(() => although.isEnabled()).toBe(true);
  await dialog.getByRole('button', {name: 'Repeat 2'}).click();
  await expect.poll(lines, patient).toBeLessThan(before);
  // the user's choice is not in doubt
  await expect.poll(() => use(page).isEnabled(), patient).toBe(true);
  await expect.poll(() => although.count()).toBe(0);
  await dialog.getByRole('button', {name: 'Undo'}).click();
  await expect.poll(lines).toBe(before);
  await although.click();
  await expect.poll(() => dialogOf(page).count(), patient).toBe(0);
  await page.getByText('Your own: pm').waitFor();
});
