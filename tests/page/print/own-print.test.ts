/** Adding one's own image as a print, and messages for unsuitable images. */
import {createCanvas, loadImage} from '@napi-rs/canvas';
import type {Page} from 'playwright-core';
import {expect, it} from 'vitest';

import {barriers} from '../../support/page/barriers.js';
import {cut, halfDrop, leaf, painted, pngOf} from '../../support/image/pictures.js';
import {button, usePage} from '../../support/page/page.js';
import {designOf} from '../../support/page/design.js';
import {sampleOf} from '../../support/level.js';

const openPage = usePage();

/** A page that does not solve; these tests need no answer. */
const quietPage = async (width = 640): Promise<Page> => {
  const page = await openPage({viewport: {width, height: 700}});
  const cutting = page
    .getByRole('navigation', {name: 'Panels'})
    .getByRole('button', {name: 'Pattern', exact: true});
  const isPhone = width < 640; // panels are bottom sheets there, one at a time
  if (isPhone) await cutting.click();
  await page.getByRole('switch', {name: 'Match after each change'}).press('Space');
  if (isPhone) await page.getByRole('button', {name: 'Fabric', exact: true}).click();
  return page;
};

const give = (page: Page, name: string, content: Buffer | string): Promise<void> =>
  page
    .locator('sw-print-panel input[type=file]')
    .setInputFiles({name, mimeType: '', buffer: Buffer.from(content)});

const leafFile = (dpi?: number): Buffer => pngOf(painted(240, 200, leaf), dpi);
const repeat = (page: Page, name: string) => page.getByRole('radio', {name, exact: true});

it('is as large as its file says, and again when asked', {tags: ['thorough']}, async () => {
  const page = await quietPage();
  await give(page, 'leaf.png', leafFile(100));
  await page.getByText('Size in the file: 100 dpi, 6.1 cm wide').waitFor();
  const {size} = (await designOf(page)).print;
  expect([size.width, size.height].map((side) => side.toFixed(2))).toEqual(['6.10', '5.08']);
  await page.getByLabel('Repeat width (cm)').fill('12');
  await page.getByLabel('Repeat width (cm)').press('Enter');
  await button(page, 'Size from the file: 100 dpi, 6.1 cm wide').click();
  await page.getByText('Size in the file: 100 dpi').waitFor();
  expect((await designOf(page)).print.size.height).toBeCloseTo(5.08, 2);
  await give(page, 'unsaid.png', leafFile());
  await page.getByText('The file has no printed size').waitFor();
});

it(
  'repeats in half-drop, brick or mirrored, with the measures of the picture',
  {tags: ['thorough']},
  async () => {
    const page = await quietPage();
    await give(page, 'leaf.png', leafFile(100));
    await page.getByText('Your own: leaf').waitFor();
    const straight = (await designOf(page)).print;
    await repeat(page, 'Half-drop').click();
    await page.getByRole('radio', {name: 'Half-drop', exact: true, checked: true}).waitFor();
    const dropped = (await designOf(page)).print;
    expect(dropped).toMatchObject({group: 'p1', cell: 'centred', tile: {repeat: 'halfDrop'}});
    expect(dropped.size.width).toBeCloseTo(2 * straight.size.width, 9);
    await expect.poll(() => page.getByLabel('Repeat width (cm)').inputValue()).toBe('6.1');
    // the pixels of the image are unchanged
    const pixels = await page.evaluate(async (url) => {
      const image = new Image();
      image.src = url;
      await image.decode();
      return [image.naturalWidth, image.naturalHeight];
    }, dropped.image);
    expect(pixels).toEqual([480, 200]);
    await page.keyboard.press('ArrowRight');
    await page.getByRole('radio', {name: 'Brick', exact: true, checked: true}).waitFor();
    await repeat(page, 'Mirrored').click();
    await page.getByText('Found in the picture: Mirrors both ways.').waitFor();
    expect((await designOf(page)).print).toMatchObject({group: 'pmm', tile: {repeat: 'mirrored'}});
    await repeat(page, 'Straight').click();
    await page.getByText('Found in the picture: Repeats, without').waitFor();
    expect((await designOf(page)).print).toEqual(straight);
  },
);

it(
  'is not taken while its edges do not meet, and can be mirrored with one click',
  {tags: ['thorough']},
  async () => {
    const page = await quietPage();
    const before = await designOf(page);
    await give(page, 'cut.png', pngOf(painted(220, 200, cut)));
    await page.getByText('cut does not repeat. Its edges do not meet.').waitFor();
    const marks = page.getByRole('img', {name: 'cut, with'}).locator('path').first();
    await expect.poll(() => marks.getAttribute('d')).toMatch(/^M0 0\.\d+V0\.\d+M1 0/);
    expect(await designOf(page)).toEqual(before);
    await button(page, 'Mirror it').click();
    await page.getByText('Your own: cut').waitFor();
    expect((await designOf(page)).print).toMatchObject({group: 'pmm', tile: {repeat: 'mirrored'}});
    await page.getByText('does not repeat as it is').waitFor({state: 'detached'});
  },
);

it(
  'is known as a half-drop by its edges, or taken as it is when that is meant',
  {tags: ['thorough']},
  async () => {
    const page = await quietPage();
    const file = pngOf(painted(220, 200, halfDrop));
    await give(page, 'drop.png', file);
    await page.getByText('Its left and right edges do not meet.').waitFor();
    await button(page, 'It is a half-drop').click();
    await page.getByText('Your own: drop').waitFor();
    expect((await designOf(page)).print.tile).toMatchObject({repeat: 'halfDrop'});
    await give(page, 'drop again.png', file);
    await button(page, 'Use it anyway').click();
    await page.getByText('Your own: drop again').waitFor();
    expect((await designOf(page)).print).toMatchObject({group: 'p1', cell: 'primitive'});
    await page.getByText('Its left and right edges do not meet.').waitFor(); // remains for this use
  },
);

/** Two cells of a sample side by side, starting from any point. */
async function twoCells(name: string, [x, y]: readonly [number, number]): Promise<Buffer> {
  const image = await loadImage(new URL(`../../../public/prints/${name}.png`, import.meta.url));
  const {width, height} = image;
  const canvas = createCanvas(2 * width, height);
  const context = canvas.getContext('2d');
  for (const i of [0, 1, 2]) {
    for (const j of [0, 1]) {
      context.drawImage(image, (i - x) * width, (j - y) * height);
    }
  }
  return canvas.toBuffer('image/png');
}

it.each(
  sampleOf(1, [
    ['p4m', 1],
    ['cmm', 5 / 7],
    ['pgg', 9 / 11],
  ]),
)(
  'is cut to one cell of %s where it shows two that begin anywhere',
  {tags: ['thorough']},
  async (name, ratio) => {
    const page = await quietPage();
    await give(page, 'two.png', await twoCells(name, [0.375, 0.25]));
    await page.getByText('Your own: two').waitFor();
    await page.getByText('Found in the picture:').waitFor();
    const {group, size, image} = (await designOf(page)).print;
    expect({group, width: size.width}).toEqual({group: name, width: 5});
    const pixels = await page.evaluate(async (url) => {
      const shown = new Image();
      shown.src = url;
      await shown.decode();
      return shown.naturalWidth / shown.naturalHeight;
    }, image);
    expect(pixels).toBeCloseTo(ratio, 1);
  },
);

it('is measured by two points, by mouse or by keys', {tags: ['thorough']}, async () => {
  const page = await quietPage();
  await give(page, 'leaf.png', leafFile(100));
  await page.getByText('Your own: leaf').waitFor();
  await button(page, 'Measure on the picture').click();
  const picture = page.locator('sw-measure .picture');
  const box = await picture.boundingBox();
  if (!box) throw new Error('There is no picture.');
  expect(box.width / box.height).toBeCloseTo(1.2, 1);
  await picture.click({position: {x: 1, y: box.height - 2}});
  await picture.click({position: {x: box.width - 2, y: box.height - 2}});
  const distance = page.getByLabel('Distance between them (cm)');
  await expect.poll(async () => Number(await distance.inputValue())).toBeCloseTo(6.1, 0);
  const second = button(page, 'Second point');
  await second.focus();
  for (let k = 0; k < 25; k++) await page.keyboard.press('Shift+ArrowLeft');
  // 25 steps of a fiftieth: half of the width
  await expect.poll(async () => Number(await distance.inputValue())).toBeCloseTo(3.05, 1);
  await distance.fill('10');
  await distance.press('Enter');
  await page.getByText(/One repeat is then (19|20)(\.\d)? cm/).waitFor();
  expect(await barriers(page)).toEqual([]);
  await button(page, 'Use this size').click();
  expect((await designOf(page)).print.size.width).toBeCloseTo(20, 0);
  await expect.poll(() => page.getByRole('dialog').count()).toBe(0);
});

it(
  'is no print where it is damaged or another kind of file, and the print before stays',
  {tags: ['thorough']},
  async () => {
    const page = await quietPage();
    const before = await designOf(page);
    const damaged = leafFile();
    damaged[60] = (damaged[60] ?? 0) ^ 1;
    const tail = 'which cannot be a print: save it as PNG or JPEG, and open that.';
    const svg = (inside: string): string =>
      `<svg xmlns="http://www.w3.org/2000/svg" width="9" height="9">${inside}</svg>`;
    for (const [name, content, said] of [
      ['a.png', damaged, 'a.png is a PNG picture, but damaged'],
      ['b.jpg', leafFile().subarray(0, 90), 'b.jpg is a PNG picture, but damaged'],
      ['c.jpg', Buffer.from('\xff\xd8\xff\xe0\0\x02', 'latin1'), 'c.jpg is a JPEG picture, but'],
      [
        'd.svg',
        '<svg xmlns="http://www.w3.org/2000/svg"><g>',
        'd.svg is an SVG drawing, but damaged',
      ],
      ['e.gif', 'GIF89a', `e.gif is a GIF picture, ${tail}`],
      ['f.pdf', '%PDF-1.4', `f.pdf is a PDF document, ${tail}`],
      ['g.tif', 'II*\0', `g.tif is a TIFF picture, ${tail}`],
      ['h.png', '\0\0\0\x18ftypheic\0\0\0\0', `h.png is a HEIC photo, ${tail}`],
      ['i.json', '{"pattern": {}}', 'i.json is a sewing pattern: open it with My pattern.'],
      ['j.svg', svg('<image href="photo.jpg"/>'), 'j.svg links to other pictures'],
      ['k.svg', svg('<rect fill="url(https://a.b/c.svg#d)"/>'), 'k.svg links to other pictures'],
    ] as const) {
      await give(page, name, content);
      await page.getByText(said).waitFor();
    }
    expect(await designOf(page)).toEqual(before);
  },
);

it('says all of it without a fault that axe could find', {tags: ['thorough']}, async () => {
  const page = await quietPage(390);
  await give(page, 'leaf.png', leafFile(72));
  await page.getByText('Your own: leaf').waitFor();
  await give(page, 'cut.png', pngOf(painted(220, 200, cut)));
  await page.getByText('cut does not repeat.').waitFor();
  expect(await barriers(page)).toEqual([]);
});
