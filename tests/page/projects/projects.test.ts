/** Each opened garment is a separate project, and none replaces another. */
import type {Locator, Page} from 'playwright-core';
import {expect, it, vi} from 'vitest';

import type {SeamwisePage} from '@/app/page.js';
import type {ProjectList} from '@/app/projects/project-list.js';
import {barriers} from '../../support/page/barriers.js';
import {designOf} from '../../support/page/design.js';
import {hand, jsonFile, squares} from '../../support/page/files.js';
import {chooseGroup, groupOf, quiet, reloaded} from '../../support/page/quiet.js';
import {button, usePage, type PageOptions} from '../../support/page/page.js';

vi.setConfig({testTimeout: 180_000}); // a busy machine is slow at everything

const openPage = usePage();
const quietPage = (options?: PageOptions): Promise<Page> => quiet(openPage, options);

const shows = (page: Page, file: string): Promise<void> =>
  expect.poll(async () => (await designOf(page)).garment.name, {timeout: 20_000}).toBe(file);

const chooseSample = async (page: Page, style: string): Promise<void> => {
  await page.getByLabel('Garment', {exact: true}).selectOption(style);
  await shows(page, `${style}-m.json`);
};

const drop = async (page: Page, name: string): Promise<void> => {
  await hand(page, 'drop', jsonFile(name, squares(20)));
  await shows(page, name);
};

/** Opens the list. */
const listOf = async (page: Page): Promise<Locator> => {
  await button(page, 'Projects').click();
  const list = page.getByRole('dialog', {name: 'Projects'});
  await list.waitFor();
  return list;
};

const cards = (list: Locator): Promise<string[]> =>
  list
    .getByRole('textbox', {name: /^Name of the project/})
    .evaluateAll((fields) => fields.map((field) => (field as HTMLInputElement).value));

const card = (list: Locator, name: string): Locator =>
  list.getByRole('button', {name: `Open ${name}`, exact: true});

it(
  'keeps what is worked on when something else is opened, and goes back to it',
  {tags: ['thorough']},
  async () => {
    const page = await quietPage();
    await chooseGroup(page, 'pgg');
    const before = await designOf(page);
    await drop(page, 'scarf.json');
    expect(await page.title()).toBe('scarf – Seamwise');
    await expect.poll(() => button(page, 'Undo').isDisabled()).toBe(true);
    await page.getByText('“Asymmetric dress, M” is kept under Projects.').waitFor();
    await button(page, 'Back to it').click();
    await shows(page, 'asymmetric-dress-m.json');
    expect(await designOf(page)).toEqual(before);
    expect(await page.title()).toBe('Asymmetric dress, M – Seamwise');
    await button(page, 'Undo').click();
    expect(await groupOf(page)).not.toBe('pgg');
    expect(await cards(await listOf(page))).toEqual(['Asymmetric dress, M', 'scarf']);
  },
);

it(
  'goes on in a new tab with what was worked on last, unless another tab works on it',
  {tags: ['thorough']},
  async () => {
    const page = await quietPage();
    await drop(page, 'scarf.json');
    await chooseGroup(page, 'pgg');
    const beside = await quietPage({beside: page});
    await shows(beside, 'asymmetric-dress-m.json');
    await page.close();
    await beside.close({runBeforeUnload: false});
    const later = await openPage({beside});
    await shows(later, 'scarf.json');
    expect(await groupOf(later)).toBe('pgg');
    await button(later, 'Undo').click();
    expect(await groupOf(later)).not.toBe('pgg');
  },
);

it(
  'leaves what cannot be read unopened, and everything as it was',
  {tags: ['thorough']},
  async () => {
    const page = await quietPage();
    await chooseGroup(page, 'pgg');
    const before = await designOf(page);
    await hand(page, 'drop', jsonFile('torn.json', '{"pattern": 1}'));
    await page.getByRole('alert').filter({hasText: 'torn.json'}).waitFor();
    expect(await designOf(page)).toEqual(before);
    await expect.poll(() => button(page, 'Undo').isEnabled()).toBe(true);
    expect(await cards(await listOf(page))).toEqual(['Asymmetric dress, M']);
  },
);

it(
  'lists projects with their pictures in every tab, and opens them with their history',
  {tags: ['thorough']},
  async () => {
    const page = await quietPage();
    await chooseSample(page, 'apron');
    const plain = await groupOf(page);
    await chooseGroup(page, 'pgg');
    const before = await designOf(page);
    await button(page, 'Match print').click(); // unsolved projects have an image, too
    const list = await listOf(page);
    await card(list, 'Apron, M').locator('img').waitFor({timeout: 60_000});
    expect(await barriers(page)).toEqual([]);
    const other = await quietPage({beside: page});
    await shows(other, 'asymmetric-dress-m.json');
    await page.close();
    const otherList = await listOf(other);
    const [width, height] = await card(otherList, 'Apron, M')
      .locator('img')
      .evaluate(async (image: HTMLImageElement) => {
        await image.decode();
        return [image.naturalWidth, image.naturalHeight];
      });
    expect(width).toBe(448);
    expect(height).toBeGreaterThan(100);
    await card(otherList, 'Apron, M').click();
    await shows(other, 'apron-m.json');
    expect(await designOf(other)).toEqual(before);
    await button(other, 'Undo').click();
    expect(await groupOf(other)).toBe(plain);
  },
);

it('does not list samples that were only looked at', {tags: ['thorough']}, async () => {
  const page = await quietPage();
  for (const style of ['apron', 'tee', 'shirt']) await chooseSample(page, style);
  await reloaded(page);
  await shows(page, 'shirt-m.json'); // the last one is restored
  expect(await cards(await listOf(page))).toEqual(['Shirt, M']);
});

it('calls window and files by the name that somebody gives a project', async () => {
  const page = await quietPage();
  await drop(page, 'scarf.json');
  const list = await listOf(page);
  await list.getByRole('textbox').fill('For Ada: 1/2');
  await page.locator('sw-project-list').evaluate(async (element) => {
    const list = element as ProjectList;
    list.requestUpdate(); // as a preview image does that arrives meanwhile
    await list.updateComplete;
  });
  await page.keyboard.press('Enter');
  await expect.poll(() => page.title()).toBe('For Ada: 1/2 – Seamwise');
  await page.keyboard.press('Escape');
  await list.waitFor({state: 'hidden'});
  await button(page, 'Save …').click();
  const [file] = await Promise.all([
    page.waitForEvent('download'),
    button(page, 'Save project').click(),
  ]);
  expect(file.suggestedFilename()).toBe('For Ada 1 2.seamwise.json');
  await reloaded(page);
  expect(await page.title()).toBe('For Ada: 1/2 – Seamwise');
  const again = await listOf(page);
  await again.getByRole('textbox').fill('');
  await page.keyboard.press('Enter');
  await expect.poll(() => page.title()).toBe('scarf – Seamwise');
});

it('duplicates a project, deletes one, and takes that back', {tags: ['thorough']}, async () => {
  const page = await quietPage();
  await drop(page, 'scarf.json');
  const list = await listOf(page);
  await button(page, 'Duplicate scarf').click();
  await expect.poll(() => cards(list)).toEqual(['scarf 2', 'scarf']);
  await button(page, 'Delete scarf').click(); // the current one
  await list.getByText('scarf was deleted.').waitFor();
  expect(await cards(list)).toEqual(['scarf 2']);
  await expect.poll(() => page.title()).toBe('scarf 2 – Seamwise');
  const undo = list.getByRole('button', {name: 'Undo: bring scarf back'});
  await expect.poll(() => undo.evaluate((element) => element.matches(':focus'))).toBe(true);
  await undo.press('Enter');
  await expect.poll(() => cards(list)).toEqual(['scarf 2', 'scarf']);
  await expect
    .poll(() => card(list, 'scarf').evaluate((element) => element.matches(':focus')))
    .toBe(true);
  await button(page, 'Delete scarf').click();
  await button(page, 'Delete scarf 2').click();
  await shows(page, 'asymmetric-dress-m.json'); // the first visit's sample, as no project is left
  await reloaded(page);
  expect(await cards(await listOf(page))).toEqual(['Asymmetric dress, M']);
});

it(
  'gives a second tab a copy of what is open in the first, and lets it delete nothing of it',
  {tags: ['thorough']},
  async () => {
    const page = await quietPage();
    await chooseGroup(page, 'pgg');
    const other = await quietPage({beside: page});
    const list = await listOf(other);
    await list.getByText('open in another tab').waitFor();
    // only the tab's own copy can be deleted
    await expect.poll(() => button(other, 'Delete Asymmetric dress, M').count()).toBe(1);
    await card(list, 'Asymmetric dress, M').last().click();
    await other.getByText('The project is open in another tab').waitFor();
    await chooseGroup(other, 'cmm');
    await chooseGroup(page, 'p6m');
    await Promise.all([reloaded(page), reloaded(other)]);
    expect([await groupOf(page), await groupOf(other)]).toEqual(['p6m', 'cmm']);
  },
);

it(
  'keeps projects as long as the tab lives where the browser keeps nothing, and says so',
  {tags: ['thorough']},
  async () => {
    const page = await openPage({viewport: {width: 640, height: 480}});
    await page.addInitScript(() => {
      Object.defineProperty(globalThis, 'indexedDB', {value: undefined});
    });
    await page.reload();
    await quiet(() => Promise.resolve(page));
    await chooseGroup(page, 'pgg');
    const note = 'This browser cannot keep your work; save the project before you leave.';
    await page.getByRole('alert').filter({hasText: note}).waitFor();
    await drop(page, 'scarf.json');
    const list = await listOf(page);
    await list.getByText(note).waitFor();
    await expect.poll(() => cards(list)).toEqual(['scarf', 'Asymmetric dress, M']);
    await card(list, 'Asymmetric dress, M').click();
    await shows(page, 'asymmetric-dress-m.json');
    expect(await groupOf(page)).toBe('pgg');
    await reloaded(page);
    expect(await groupOf(page)).toBe('pgg');
  },
);

it(
  'carries a garment, a print, how that repeats, and a name of somebody’s own in a link',
  {tags: ['thorough']},
  async () => {
    const page = await quietPage({permissions: ['clipboard-read', 'clipboard-write']});
    await drop(page, 'scarf.json');
    await hand(page, 'drop', {
      name: 'dots.svg',
      mimeType: 'image/svg+xml',
      content: `<svg xmlns="http://www.w3.org/2000/svg" width="90" height="60"><path d="${'M1 2h3'.repeat(900)}" stroke="#000"/></svg>`,
    });
    await expect.poll(async () => (await designOf(page)).print.title).toBe('dots');
    await page.getByRole('radio', {name: 'Half-drop', exact: true}).click();
    await expect.poll(async () => (await designOf(page)).print.tile?.repeat).toBe('halfDrop');
    await page.locator('seamwise-page').evaluate((element) => {
      (element as SeamwisePage).workbench.solving.align();
    });
    await button(page, 'Save …').click({timeout: 60_000});
    await button(page, 'Copy link').click();
    const copied = async (): Promise<string> => page.evaluate(() => navigator.clipboard.readText());
    await page.getByText(/It leaves out the pattern/).waitFor();
    const without = await copied();
    await button(page, 'It is mine to share').click();
    await expect.poll(copied).not.toBe(without);
    const design = await designOf(page);
    const link = await copied();
    expect(link.length).toBeLessThan(3000);
    const other = await quietPage({query: new URL(link).hash});
    expect(await designOf(other)).toEqual(design);
    await expect.poll(() => other.url()).not.toContain('#');
    expect(await cards(await listOf(other))).toEqual(['scarf']);
    // whoever has the pattern needs only the rest, and whoever has not is told
    await other.goto(without);
    await expect.poll(async () => (await designOf(other)).garment.text).toBe(design.garment.text);
    const stranger = await quietPage({query: new URL(without).hash});
    await stranger.getByText(/left out the pattern “scarf.json”/).waitFor();
  },
);

it(
  'says that a link is damaged, and leaves everything as it was',
  {tags: ['thorough']},
  async () => {
    const page = await quietPage();
    await chooseGroup(page, 'pgg');
    const before = await designOf(page);
    await page.evaluate(() => {
      location.hash = '#project=7VtLc9s4Ej';
    });
    await page.getByRole('alert').filter({hasText: 'The link is damaged'}).waitFor();
    expect(await designOf(page)).toEqual(before);
    await expect.poll(() => button(page, 'Undo').isEnabled()).toBe(true);
    await Promise.all([
      page.waitForEvent('load'),
      page.evaluate(() => {
        history.replaceState(null, '', '#design=AAAA');
        location.reload();
      }),
    ]);
    await page.getByRole('alert').filter({hasText: 'The link is damaged'}).waitFor();
    expect(await designOf(page)).toEqual(before);
  },
);
