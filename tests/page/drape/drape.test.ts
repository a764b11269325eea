/** The drape on the page, beside or instead of the pattern, with a selection that both share. */

import type {Page} from 'playwright-core';
import {expect, it} from 'vitest';

import type {SeamwisePage} from '@/app/page.js';
import {bytesOf} from '../../support/page/browser.js';
import {button, saved, smallest, solved, usePage} from '../../support/page/page.js';
import {readGlb} from '../../support/drape/read-glb.js';
import {frames} from '../../support/page/waiting.js';

const openPage = usePage();

/** The page with the drape instead of the pattern. */
async function openWorn(): Promise<Page> {
  const page = await openPage({
    ...{viewport: {width: 1300, height: 800}, reducedMotion: 'no-preference'},
  });
  await solved(page);
  await page.locator('sw-editor .views').getByRole('button', {name: 'Garment'}).click();
  const status = page.locator('sw-drape-pane [role=status]');
  await expect.poll(() => status.textContent(), {timeout: 120_000}).toContain('view.');
  return page;
}

it('shows the garment worn in place of the pattern, beside it, and marks in both what is picked in one', async () => {
  const page = await openPage({
    ...{query: smallest, viewport: {width: 1100, height: 640}},
    reducedMotion: 'no-preference', // shows the garment on its way, and flies to what is picked
  });
  await solved(page);
  const views = page.locator('sw-editor .views');
  const worn = page.locator('sw-drape-pane');
  await expect.poll(() => worn.count()).toBe(0);
  await views.getByRole('button', {name: 'Garment'}).click();
  const status = worn.locator('[role=status]');
  await expect
    .poll(() => status.textContent(), {timeout: 120_000})
    .toContain('Three-quarter view.');
  await expect.poll(() => page.locator('sw-pattern').isVisible()).toBe(false);
  await views.getByRole('button', {name: 'Both'}).click();
  await expect.poll(() => page.locator('sw-pattern').isVisible()).toBe(true);
  const picked = () =>
    page.evaluate(() => {
      const {workbench} = document.querySelector<SeamwisePage>('seamwise-page') ?? {};
      const selected = workbench?.selection.selected;
      const pattern = workbench?.solving.pattern;
      return selected?.kind === 'piece' ? pattern?.pieces[selected.piece]?.name : selected?.kind;
    });
  await worn.getByRole('combobox', {name: 'Seen from'}).selectOption('front');
  await expect.poll(() => status.textContent(), {timeout: 30_000}).toContain('Front view.');
  // beside the middle of the chest, where no seam can be
  const stage = await worn.locator('.stage').boundingBox();
  if (!stage) throw new Error('The garment has no stage.');
  const [x, y] = [stage.x + 0.47 * stage.width, stage.y + 0.42 * stage.height];
  await expect
    .poll(
      async () => {
        await page.mouse.click(x, y);
        return picked();
      },
      {timeout: 30_000},
    )
    .toMatch(/front/);
  // a selection elsewhere turns the camera towards it
  await page.evaluate(() => {
    const {workbench} = document.querySelector<SeamwisePage>('seamwise-page') ?? {};
    const back =
      workbench?.solving.pattern?.pieces.findIndex(({name}) => name.includes('back')) ?? -1;
    workbench?.selection.select({kind: 'piece', piece: back});
  });
  await expect.poll(() => status.textContent(), {timeout: 30_000}).toContain('Back view.');
});

it(
  'shows the pieces again where the worn garment took their place',
  {tags: ['thorough']},
  async () => {
    const page = await openWorn();
    const views = page.locator('sw-editor .views');
    const stages = {Pattern: 'sw-pattern .stage', Garment: 'sw-drape-pane .stage'};
    for (const name of ['Pattern', 'Garment', 'Pattern'] as const) {
      await views.getByRole('button', {name}).click();
      // an empty image takes next to no bytes
      await expect
        .poll(async () => (await page.locator(stages[name]).screenshot()).length, {timeout: 20_000})
        .toBeGreaterThan(40_000);
    }
  },
);

it(
  'keeps the worn garment in sight while another print is on its way',
  {tags: ['thorough']},
  async () => {
    const page = await openWorn();
    const worn = page.locator('sw-drape-pane');
    const status = worn.locator('[role=status]');
    await page.evaluate(() => {
      const {workbench} = document.querySelector<SeamwisePage>('seamwise-page') ?? {};
      const print = workbench?.history.design?.print;
      if (print)
        workbench.history.change({
          print: {...print, size: {...print.size, width: 1.1 * print.size.width}},
        });
    });
    // never an empty image, which takes next to no bytes
    for (let k = 0; k < 8; k++) {
      const picture = await worn.locator('.stage').screenshot();
      expect(picture.length).toBeGreaterThan(20_000);
      await frames(page, 4);
    }
    await expect.poll(() => status.textContent(), {timeout: 120_000}).toContain('view.');
  },
);

it(
  'wipes between before and after by a handle that keys move as well, and by a key that is held',
  {tags: ['thorough']},
  async () => {
    const page = await openWorn();
    const worn = page.locator('sw-drape-pane');
    const stage = await worn.locator('.stage').boundingBox();
    if (!stage) throw new Error('The garment has no stage.');
    /** Images of the garment on both sides of the middle, off the line itself. */
    const halves = async (): Promise<readonly [string, string]> => {
      const {x, y, width, height} = stage;
      const half = {y: y + 0.1 * height, width: 0.15 * width, height: 0.5 * height};
      const seen = async (from: number): Promise<string> =>
        (await page.screenshot({clip: {...half, x: x + from * width}})).toString('base64');
      return [await seen(0.32), await seen(0.53)];
    };
    await expect.poll(() => worn.locator('progress').isVisible(), {timeout: 60_000}).toBe(false);
    const [left, right] = await halves();
    await worn.getByRole('button', {name: 'Before and after'}).click();
    const handle = worn.getByRole('slider', {name: 'Before and after'});
    await expect.poll(() => handle.inputValue()).toBe('50');
    await expect.poll(async () => (await halves())[0], {timeout: 20_000}).not.toBe(left);
    expect((await halves())[1]).toBe(right);
    await handle.focus();
    await page.keyboard.press('ArrowRight');
    await expect.poll(() => handle.inputValue()).toBe('51');
    await page.keyboard.press('End');
    await expect.poll(async () => (await halves())[1], {timeout: 20_000}).not.toBe(right);
    const track = await handle.boundingBox();
    if (!track) throw new Error('The handle has no box.');
    const middle = track.y + track.height / 2;
    await page.mouse.move(stage.x + stage.width - 1, middle);
    await page.mouse.down();
    await page.mouse.move(stage.x + 1, middle, {steps: 4});
    await page.mouse.up();
    expect(Number(await handle.inputValue())).toBeLessThan(2);
    await worn.getByRole('button', {name: 'Before and after'}).click();
    await expect.poll(() => handle.count()).toBe(0);
    await page.getByRole('application', {name: 'Garment, worn'}).focus();
    await page.keyboard.down('w');
    await expect.poll(async () => (await halves())[1], {timeout: 20_000}).not.toBe(right);
    await page.keyboard.up('w');
    await expect.poll(async () => (await halves())[1], {timeout: 20_000}).toBe(right);
  },
);

it(
  'is of a fabric that can be taken back, and that the project keeps',
  {tags: ['thorough']},
  async () => {
    const page = await openWorn();
    const fabric = page.locator('sw-drape-pane').getByLabel('Fabric');
    await expect.poll(() => fabric.inputValue()).toBe('poplin');
    await fabric.selectOption('denim');
    await expect.poll(() => button(page, 'Undo').getAttribute('title')).toBe('Undo: fabric');
    expect(JSON.parse(await saved(page, 'Save project'))).toMatchObject({
      design: {fabric: 'denim'},
    });
    await solved(page); // the answer does not depend on it
    await button(page, 'Undo').click();
    await expect.poll(() => fabric.inputValue()).toBe('poplin');
    await button(page, 'Redo').click();
    await page.reload();
    await solved(page);
    await page.locator('sw-editor .views').getByRole('button', {name: 'Garment'}).click();
    await expect.poll(() => fabric.inputValue()).toBe('denim');
  },
);

it('gives away a picture of what is seen, a model and a film', {tags: ['thorough']}, async () => {
  const page = await openWorn();
  // both views, since nothing has the focus
  await page.keyboard.press('v');
  await page.keyboard.press('v');
  await expect
    .poll(() => page.locator('sw-drape-pane progress').isVisible(), {timeout: 60_000})
    .toBe(false);
  const given = async (name: string): Promise<{name: string; bytes: Buffer}> => {
    if (!(await button(page, name).isVisible())) await button(page, 'Save …').click();
    const [download] = await Promise.all([
      page.waitForEvent('download', {timeout: 60_000}),
      button(page, name).click(),
    ]);
    return {name: download.suggestedFilename(), bytes: await bytesOf(download)};
  };
  const picture = await given('Save picture of the garment');
  expect(picture.name).toMatch(/\.worn\.png$/);
  const stage = await page.locator('sw-drape-pane .stage').boundingBox();
  expect(picture.bytes.readUInt32BE(16)).toBe(2 * Math.round(stage?.width ?? 0));
  const model = await given('Save 3D model (GLB)');
  expect(model.name).toMatch(/\.glb$/);
  const {json} = readGlb(model.bytes);
  expect(json).toMatchObject({
    extras: {format: 'seamwise-glb/1', garment: 'Asymmetric dress m'},
    images: [{mimeType: 'image/png'}],
  });
  const film = await given('Save film of a turn');
  expect(film.name).toMatch(/\.webm$/);
  expect(film.bytes.subarray(0, 4).toString('hex')).toBe('1a45dfa3');
  expect(film.bytes.length).toBeGreaterThan(50_000);
});
