/** Choosing a print, measuring its repeat, and adding one's own. */
import type {Locator, Page} from 'playwright-core';
import {expect, it} from 'vitest';

import type {SeamwisePage} from '@/app/page.js';
import {button, usePage} from '../../support/page/page.js';
import {designOf} from '../../support/page/design.js';
import {choose} from '../../support/page/files.js';
import {printRadio} from '../../support/page/prints.js';

const openPage = usePage();

/**
 * A small page that does not solve; these tests need no answer. The print is p4m, the group with
 * the most constraints.
 */
const quietPage = async (): Promise<Page> => {
  const page = await openPage({viewport: {width: 640, height: 480}});
  await page.getByRole('switch', {name: 'Match after each change'}).press('Space');
  await group(page, 'p4m').click();
  await group(page, 'p4m')
    .and(page.getByRole('radio', {checked: true}))
    .waitFor();
  return page;
};

const group = (page: Page, name: string): Locator => printRadio(page, name);

const enter = async (page: Page, label: string, value: string): Promise<void> => {
  await page.getByLabel(label).fill(value);
  await page.getByLabel(label).press('Enter');
};

const proportions = (page: Page): Locator => button(page, 'Keep the proportions');

const open = (page: Page, name: string, mimeType: string, content: string): Promise<void> =>
  choose(page, 'My fabric', {name, mimeType, content});

/**
 * A tile of 20 by 10 with a disc in its middle, which has both mirrors, and any further drawing.
 */
const tile = (more = ''): string =>
  `<svg xmlns="http://www.w3.org/2000/svg" width="200" height="100" viewBox="0 0 20 10"><rect width="20" height="10" fill="#fff"/><circle cx="10" cy="5" r="3" fill="#a33"/>${more}</svg>`;
const blot = '<rect x="1" y="1" width="3" height="2" fill="#237"/>';

it('offers the 17 groups and stripes, which arrow keys walk through', async () => {
  const page = await quietPage();
  const gallery = page.getByRole('radiogroup', {name: 'Symmetry of the print'});
  await expect.poll(() => gallery.getByRole('radio').count()).toBe(18);
  await page.getByRole('radio', {name: 'Majolica', checked: true}).focus();
  await page.keyboard.press('ArrowRight');
  await page.getByRole('radio', {name: 'Bay trellis', checked: true}).waitFor();
  await page.keyboard.press('ArrowDown'); // three further, in the next row
  await page.getByRole('radio', {name: 'Trillium', checked: true}).waitFor();
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('ArrowRight');
  await page.keyboard.press('ArrowRight');
  await page.getByRole('radio', {name: 'Ticking', checked: true}).waitFor();
  await expect.poll(() => gallery.getByRole('radio', {checked: true}).count()).toBe(1);
  expect((await designOf(page)).print).toMatchObject({group: 'pmm', sample: {name: 'ticking'}});
});

it('names its prints, and shows only those that are looked for', {tags: ['thorough']}, async () => {
  const page = await quietPage();
  const majolica = page.getByRole('radio', {name: 'Majolica'});
  await expect.poll(() => majolica.innerText()).toBe('Majolica');
  await expect.poll(() => majolica.getAttribute('title')).toMatch(/^Mirrors both ways/);
  const radios = page.getByRole('radiogroup', {name: 'Symmetry of the print'}).getByRole('radio');
  const tartan = button(page, 'Tartan');
  await button(page, 'Stripes and checks').click();
  await expect.poll(() => radios.allInnerTexts()).toEqual(['Foulard', 'Ticking']);
  await expect.poll(() => tartan.isVisible()).toBe(true);
  await radios.first().press('ArrowRight');
  await page.getByRole('radio', {name: 'Ticking', checked: true}).waitFor();
  await button(page, 'Florals').click();
  await expect.poll(() => radios.count()).toBe(9);
  await expect.poll(() => tartan.count()).toBe(0);
  await button(page, 'With mirrors').click();
  await expect.poll(() => radios.allInnerTexts()).toContain('Snow crystal');
  await expect.poll(() => radios.allInnerTexts()).not.toContain('Trailing rose');
  await button(page, 'With mirrors').click();
  await expect.poll(() => radios.count()).toBe(18);
});

it('takes any print, and tells which symmetry it cannot keep', {tags: ['thorough']}, async () => {
  const page = await quietPage();
  await page.locator('seamwise-page').evaluate((element) => {
    (element as SeamwisePage).workbench.history.change({
      symmetry: [{kind: 'piece', piece: 'front'}],
    });
  });
  await group(page, 'p4').press('Space');
  await page.getByText(/ has no mirrors, so no piece can be symmetric\./).waitFor();
  expect((await designOf(page)).print.group).toBe('p4');
});

it('keeps the repeat when only the colours change', {tags: ['thorough']}, async () => {
  const page = await quietPage();
  await enter(page, 'Repeat width (cm)', '8');
  await button(page, 'Night').click();
  const {size, image} = (await designOf(page)).print;
  expect(size).toEqual({width: 8, height: 8, angleDeg: 90});
  expect(image).toBe('prints/p4m-night.svg');
});

it(
  'offers every print in the colours that it comes in, whatever is chosen',
  {tags: ['thorough']},
  async () => {
    const page = await quietPage();
    const offered = (): Promise<string[]> =>
      page
        .locator('.groups image, .more image')
        .evaluateAll((images) => images.map((image) => image.getAttribute('href') ?? ''));
    const before = await offered();
    await button(page, 'Night').click();
    await expect.poll(async () => (await designOf(page)).print.sample?.colourway).toBe('Night');
    expect(await offered()).toEqual(before);
    await group(page, 'p4').click();
    await group(page, 'p4')
      .and(page.getByRole('radio', {checked: true}))
      .waitFor();
    const {image} = (await designOf(page)).print;
    expect(before).toContain(image.replace('.svg', '.png'));
  },
);

it(
  'refuses a repeat that is too small or too large in one sentence',
  {tags: ['thorough']},
  async () => {
    const page = await quietPage();
    const field = page.getByLabel('Repeat width (cm)');
    for (const typed of ['0.1', '201']) {
      await enter(page, 'Repeat width (cm)', typed);
      await page.getByText('Enter a number from 0.2 cm to 200 cm.').waitFor();
      await expect.poll(() => field.getAttribute('aria-invalid')).toBe('true');
      await enter(page, 'Repeat width (cm)', '11');
      await expect.poll(() => field.getAttribute('aria-invalid')).toBeNull();
    }
    expect((await designOf(page)).print.size.width).toBe(11);
  },
);

it('keeps the proportions of a repeat until that is taken back', {tags: ['thorough']}, async () => {
  const page = await quietPage();
  await group(page, 'pmm').click();
  await page.getByRole('radio', {name: 'Harlequin', checked: true}).waitFor();
  const {width, height} = (await designOf(page)).print.size;
  await enter(page, 'Repeat width (cm)', '4');
  expect((await designOf(page)).print.size.height).toBeCloseTo((4 * height) / width, 9);
  await enter(page, 'Repeat height (cm)', String(height));
  expect((await designOf(page)).print.size.width).toBeCloseTo(width, 9);
  await proportions(page).click();
  await enter(page, 'Repeat width (cm)', '4');
  expect((await designOf(page)).print.size).toMatchObject({width: 4, height});
});

it('offers the group that still fits cloth that was measured', {tags: ['thorough']}, async () => {
  const page = await quietPage();
  await proportions(page).click();
  await enter(page, 'Repeat height (cm)', '12');
  await page.getByText(/^Your fabric is not quite “Mirrors like a square”/).waitFor();
  expect((await designOf(page)).print.size.height).toBe(11);
  await button(page, 'Take “Mirrors both ways”').click();
  await page.getByRole('radio', {name: 'Harlequin', checked: true}).waitFor();
  const {print} = await designOf(page);
  expect(print.size).toEqual({width: 11, height: 12, angleDeg: 90});
  expect(print.image).toBe('prints/p4m.svg');
});

it(
  'turns the picture where the smaller group has its axes the other way',
  {tags: ['thorough']},
  async () => {
    const page = await quietPage();
    await group(page, 'p3m1').click();
    await group(page, 'p3m1')
      .and(page.getByRole('radio', {checked: true}))
      .waitFor();
    await proportions(page).click();
    await enter(page, 'Repeat height (cm)', '18');
    await button(page, 'Take “Mirrors one way, half-drop”').click();
    await expect.poll(async () => (await designOf(page)).print.group).toBe('cm');
    const {size, turnDeg, image} = (await designOf(page)).print;
    expect([size.width, size.height, turnDeg]).toEqual([18, 10, 90]);
    expect(image).toMatch(/^data:image\/png;base64,/);
  },
);

it(
  'gives a picture the group that it has, and shows where it breaks another',
  {tags: ['thorough']},
  async () => {
    const page = await quietPage();
    await open(page, 'Dots.svg', 'image/svg+xml', tile(blot));
    await page.getByText('Your own: Dots').waitFor();
    const {print} = await designOf(page);
    expect(print).toMatchObject({group: 'p1', oneWay: true, size: {width: 10, height: 5}});
    await page.getByText('Symmetry of the print: Repeats only').click();
    await group(page, 'pmm').click();
    await page.getByText('This picture looks different from left to right').waitFor();
    const outline = page.getByRole('img', {name: 'Dots, with'}).locator('path').first();
    await expect.poll(() => outline.getAttribute('d')).not.toBe('');
    const report = page.locator('sw-tile-report');
    await report.getByRole('button', {name: 'Repeats, without turns or mirrors.'}).click();
    await page.getByText('This picture looks different').waitFor({state: 'detached'});
    await report.getByText('Repeats, without turns or mirrors.').waitFor();
  },
);

it('opens a picture with a button, and finds both of its mirrors', async () => {
  const page = await quietPage();
  await open(page, 'dot.svg', 'image/svg+xml', tile());
  await page.getByText('Your own: dot').waitFor();
  expect((await designOf(page)).print).toMatchObject({group: 'pmm', oneWay: false});
});

it('asks for the picture that a print file names, and takes it', {tags: ['thorough']}, async () => {
  const page = await quietPage();
  const file = {title: 'Mine', group: 'pmm', w1: [6, 0], w2: [0, 8], image: 'mine.svg'};
  await open(page, 'mine.json', 'application/json', JSON.stringify(file));
  await page.getByText('The picture of this print is in another file').waitFor();
  await open(page, 'mine.svg', 'image/svg+xml', tile());
  await page.getByText('Found in the picture: Mirrors both ways.').waitFor();
  expect((await designOf(page)).print).toMatchObject({
    ...{title: 'Mine', group: 'pmm', size: {width: 6, height: 8}},
  });
});

it(
  'says what is wrong with a file, and leaves the print as it is',
  {tags: ['thorough']},
  async () => {
    const page = await quietPage();
    const before = await designOf(page);
    await open(page, 'notes.txt', 'text/plain', 'hello');
    await page.getByText('notes.txt is not a print: open a picture').waitFor();
    await open(page, 'broken.png', 'image/png', 'hello');
    await page.getByText('broken.png cannot be read as a picture.').waitFor();
    await open(page, 'large.png', 'image/png', ' '.repeat(12 * 2 ** 20 + 1));
    await page.getByText('large.png is larger than 12 MB; make the picture smaller.').waitFor();
    await open(page, 'wide.svg', 'image/svg+xml', tile().replace('width="200"', 'width="9000"'));
    await page.getByText('wide.svg has more than 8192 pixels along a side').waitFor();
    expect(await designOf(page)).toEqual(before);
  },
);
