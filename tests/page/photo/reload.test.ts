/** A photo without a print yet outlives a reload, as far as the browser stores data. */
import type {Locator, Page} from 'playwright-core';
import {beforeAll, expect, it, vi} from 'vitest';

import {button, usePage} from '../../support/page/page.js';
import {dialogOf, found, give, measure, openSheet, patient, use} from '../../support/page/photo.js';
import {jpegOf} from '../../support/photo/files.js';
import {floralCase} from '../../support/photo/print-cases.js';

vi.setConfig({testTimeout: 240_000}); // a busy machine is slow at everything

const openPage = usePage();

let photographs: readonly [Buffer, Buffer];
const plain = {width: 400, height: 300, data: new Uint8ClampedArray(4 * 400 * 300).fill(200)};

beforeAll(async () => {
  const size = [900, 700] as const;
  const made = async (name: string, seed: number, group: 'pmm' | 'p4') =>
    jpegOf((await floralCase({name, level: 'scan', seed, size}, group)).pixels, 92);
  photographs = [await made('floral', 11, 'pmm'), await made('other', 5, 'p4')];
}, 240_000);

/** Numbers of stored records of unfinished photos: images and undo steps. */
const keptOf = (page: Page): Promise<readonly number[]> =>
  page.evaluate(async () => {
    const settled = <T>(request: IDBRequest<T>): Promise<T> =>
      new Promise((resolve, reject) => {
        request.onsuccess = () => {
          resolve(request.result);
        };
        request.onerror = () => {
          reject(request.error ?? new Error());
        };
      });
    const all = await indexedDB.databases();
    if (!all.some(({name}) => name === 'seamwise-unfinished')) return [0, 0];
    const database = await settled(indexedDB.open('seamwise-unfinished'));
    const stores = ['pictures', 'steps'];
    if (!stores.every((name) => database.objectStoreNames.contains(name))) return [0, 0];
    const transaction = database.transaction(stores);
    const counts = await Promise.all(
      stores.map((name) => settled(transaction.objectStore(name).count())),
    );
    database.close();
    return counts;
  });

async function again(page: Page): Promise<Locator> {
  await page.reload();
  await button(page, 'Photo of your fabric').waitFor();
  return openSheet(page);
}

const measured = (dialog: Locator): Promise<string> =>
  dialog.getByLabel('measure (cm)').first().inputValue();

/** The button to choose an image, shown without a photo. */
const intake = (dialog: Locator): Locator => dialog.getByRole('button', {name: 'Choose a picture'});

it(
  'is there with all its steps, until another is dropped or its print is taken',
  {tags: ['thorough']},
  async () => {
    const page = await openPage();
    let dialog = await openSheet(page);
    await give(page, photographs[0]);
    expect(await found(dialog)).toBe('Found: Mirrors both ways.');
    await measure(dialog, 80);
    await dialog.getByText(/One repeat is 8 cm × /).waitFor();
    await dialog.getByLabel('Name').fill('river');
    await dialog.getByLabel('Name').blur();
    await expect.poll(() => keptOf(page)).toEqual([1, 1]);
    dialog = await again(page);
    await expect.poll(() => dialog.getByText('Found: Mirrors both ways.').count()).toBe(1);
    await expect.poll(() => measured(dialog)).toBe('80');
    await expect.poll(() => dialog.getByLabel('Name').inputValue()).toBe('river');
    await dialog.getByRole('button', {name: 'Undo'}).click();
    await dialog.getByText(/^Size unknown/).waitFor();
    // also undone, and closed in between
    await page.keyboard.press('Escape');
    await expect.poll(() => dialogOf(page).count()).toBe(0);
    dialog = await again(page);
    await dialog.getByText(/^Size unknown/).waitFor();
    await dialog.getByRole('button', {name: 'Redo'}).click();
    await expect.poll(() => measured(dialog)).toBe('80');
    await give(page, photographs[1], 'other.jpg');
    await dialog.getByText('Found: Quarter turns.').waitFor(patient);
    dialog = await again(page);
    await dialog.getByText('Found: Quarter turns.').waitFor(patient);
    await expect.poll(() => dialog.getByLabel('Name').inputValue()).toBe('other');
    await expect.poll(() => keptOf(page)).toEqual([1, 1]);
    await use(page).click();
    await page.getByText('Your own: other').waitFor(patient);
    await expect.poll(() => keptOf(page)).toEqual([0, 0]);
  },
);

it(
  'is read again where its reading was cut short, and is forgotten once that is given up',
  {tags: ['thorough']},
  async () => {
    const page = await openPage();
    await openSheet(page);
    await give(page, photographs[0]);
    await expect.poll(async () => (await keptOf(page))[0]).toBe(1);
    const dialog = await again(page);
    await dialog.getByText('Found: Mirrors both ways.').waitFor(patient);
    // a photo without a print is not kept
    await give(page, await jpegOf(plain, 92));
    await dialog.getByRole('alert').waitFor(patient);
    await dialog.getByRole('button', {name: 'Close'}).click();
    await expect.poll(() => keptOf(page)).toEqual([0, 0]);
    await intake(await again(page)).waitFor();
  },
);

it(
  'is taken as a print where the browser keeps nothing, and nothing is said',
  {tags: ['thorough']},
  async () => {
    const page = await openPage();
    await page.evaluate(() => {
      const refuse = (): never => {
        throw new DOMException('There is no room.', 'QuotaExceededError');
      };
      IDBObjectStore.prototype.put = refuse;
    });
    const dialog = await openSheet(page);
    await give(page, photographs[0]);
    expect(await found(dialog)).toBe('Found: Mirrors both ways.');
    await measure(dialog, 80);
    await dialog.getByText(/One repeat is 8 cm × /).waitFor();
    await expect.poll(() => dialog.getByRole('alert').count()).toBe(0);
    expect(await keptOf(page)).toEqual([0, 0]);
    await use(page).click();
    await page.getByText('Your own: meadow').waitFor(patient);
  },
);
