/** A print read from a photo of fabric, on the page. */
import {beforeAll, describe, expect, it, vi} from 'vitest';

import {barriers} from '../../support/page/barriers.js';
import {button, smallest, solved, usePage} from '../../support/page/page.js';
import {designOf} from '../../support/page/design.js';
import {
  bring,
  dialogOf,
  found,
  give,
  measure,
  openSheet,
  patient,
  use,
  tileMade,
} from '../../support/page/photo.js';
import {decoyCases} from '../../support/photo/decoy-cases.js';
import {jpegOf} from '../../support/photo/files.js';
import {floralCase} from '../../support/photo/print-cases.js';
import {cut, painted, pngOf} from '../../support/image/pictures.js';

vi.setConfig({testTimeout: 240_000}); // a busy machine is slow at everything

const openPage = usePage();

let photograph: Buffer;
let decoy: Buffer;

beforeAll(async () => {
  const taken = await floralCase(
    {name: 'floral', level: 'scan', seed: 11, size: [900, 700]},
    'pmm',
  );
  photograph = await jpegOf(taken.pixels, 92);
  const [noise] = decoyCases(5, [700, 500]);
  if (!noise) throw new Error('There are no decoys.');
  decoy = await jpegOf((await noise()).pixels, 90);
});

describe('a photograph', () => {
  it('becomes the print: dropped, read, measured, and no request leaves the page', async () => {
    const page = await openPage({query: smallest});
    await solved(page);
    const before = await designOf(page);
    const dialog = await openSheet(page);
    const asked: string[] = [];
    await page.context().route('**', (route) => {
      asked.push(`${route.request().method()} ${route.request().url()}`);
      return route.continue();
    });
    await bring(page, photograph, 'meadow.jpg');
    expect(await found(dialog)).toBe('Found: Mirrors both ways.');
    await tileMade(dialog);
    await measure(dialog, 80);
    await dialog.getByText(/One repeat is 8 cm × /).waitFor();
    const centres = dialog.locator('sw-photo-stage .centre');
    await expect.poll(() => centres.count()).toBe(0);
    await dialog.getByLabel('Mirrors and turns', {exact: true}).check();
    await expect.poll(() => centres.count()).toBeGreaterThan(20);
    await use(page).click();
    await expect.poll(() => dialogOf(page).count(), patient).toBe(0);
    await page.getByText('Your own: meadow').waitFor();
    const {print} = await designOf(page);
    expect(print).toMatchObject({
      group: 'pmm',
      title: 'meadow',
      oneWay: false,
    });
    expect(print.size.width).toBeCloseTo(8, 3);
    expect(print.unscaled).toBeUndefined();
    expect(print.image.startsWith('data:image/png')).toBe(true);
    await solved(page);
    const origin = new URL(page.url()).origin;
    const elsewhere = asked.filter(
      (one) => !one.startsWith(`GET ${origin}/`) && !/ (blob|data):/.test(one),
    );
    expect(elsewhere).toEqual([]);
    // the photo is restored with all decisions, without another analysis
    await openSheet(page);
    await expect.poll(() => dialog.getByLabel('measure (cm)').first().inputValue()).toBe('80');
    await dialog.getByRole('button', {name: 'Close'}).click();
    await button(page, 'Undo').first().click();
    await expect.poll(async () => (await designOf(page)).print.title).toBe(before.print.title);
  });

  it('is corrected by a corner, by keys too, and undone', async () => {
    const page = await openPage({query: smallest});
    const dialog = await openSheet(page);
    await give(page, photograph);
    await found(dialog);
    const corner = dialog.getByRole('button', {name: 'Corner of the repeat'});
    const box = await corner.boundingBox();
    if (!box) throw new Error('There is no corner.');
    const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
    await page.mouse.move(x, y);
    await page.mouse.down();
    await page.mouse.move(x + 9, y + 5, {steps: 3});
    await page.mouse.up();
    const undo = dialog.getByRole('button', {name: 'Undo'});
    await expect.poll(() => undo.isEnabled(), patient).toBe(true);
    expect(await found(dialog)).toBe('Found: Mirrors both ways.');
    // the corner that was dragged, now by keys
    const place = () => corner.evaluate((handle) => handle.style.left);
    await corner.focus();
    await page.keyboard.press('Alt+Shift+ArrowRight');
    await expect.poll(() => dialog.getByRole('progressbar').count(), patient).toBe(0);
    await undo.click();
    await undo.click();
    await expect.poll(() => undo.isEnabled()).toBe(false);
    await expect.poll(place).toMatch(/%$/);
  });

  it('is stopped at once, and read again when asked', async () => {
    const page = await openPage({query: smallest});
    let release = (): void => undefined;
    const stopped = new Promise<void>((resolve) => {
      release = resolve;
    });
    // the reading cannot end before it is cancelled
    await page.route('**/photo-*.wasm', async (route) => {
      await stopped;
      await route.continue();
    });
    const dialog = await openSheet(page);
    await give(page, photograph);
    await dialog.getByRole('button', {name: 'Cancel'}).click();
    await dialog.getByText('Stopped.').waitFor({timeout: 5000});
    release();
    await expect.poll(() => use(page).isDisabled()).toBe(true);
    await dialog.getByRole('button', {name: 'Look again'}).click();
    expect(await found(dialog)).toBe('Found: Mirrors both ways.');
  });

  it(
    'without a repeat is refused by one sentence, and the cell can be drawn',
    {tags: ['thorough']},
    async () => {
      const page = await openPage({query: smallest});
      const dialog = await openSheet(page);
      await give(page, decoy, 'noise.jpg');
      await dialog.getByRole('alert').waitFor(patient);
      await expect.poll(() => dialog.getByRole('alert').innerText()).toMatch(/^[A-Z].*\.$/);
      await expect
        .poll(() => dialog.getByRole('img', {name: 'Photo of the fabric'}).isVisible())
        .toBe(true);
      await dialog.getByRole('button', {name: 'Draw the repeat by hand'}).click();
      await dialog.getByRole('button', {name: 'Find the repeat from here'}).waitFor();
      await dialog.getByRole('button', {name: 'End of the arrow: across'}).waitFor();
      await give(page, photograph.subarray(0, 90), 'half.jpg');
      await dialog.getByText('half.jpg is a JPEG picture, but damaged').waitFor();
    },
  );

  it(
    'of unknown size is aligned, but neither cut nor laid until it is measured',
    {tags: ['thorough']},
    async () => {
      const page = await openPage({query: smallest});
      await solved(page);
      const dialog = await openSheet(page);
      await give(page, photograph);
      await found(dialog);
      // only keys: the button that accepts the print has the focus
      await expect.poll(() => use(page).evaluate((one) => one.matches(':focus'))).toBe(true);
      await page.keyboard.press('Enter');
      await page.getByText('Your own: meadow').waitFor(patient);
      expect((await designOf(page)).print.unscaled).toBe(true);
      await solved(page);
      const unknown = 'The size of this print is unknown';
      await page.getByText(unknown).waitFor();
      await page.keyboard.press('Control+Shift+S');
      const cutting = page.locator('sw-cut-dialog').getByRole('dialog');
      await cutting.getByText(unknown).waitFor();
      await cutting.getByRole('button', {name: 'Close'}).click();
      await page.getByLabel('Repeat width (cm)').fill('10');
      await page.getByLabel('Repeat width (cm)').press('Enter');
      await expect.poll(async () => (await designOf(page)).print.unscaled).toBe(false);
      expect((await designOf(page)).print.size.width).toBeCloseTo(10, 6);
    },
  );
});

it('is offered for a picture whose edges do not meet', {tags: ['thorough']}, async () => {
  const page = await openPage({query: smallest});
  await page.locator('sw-print-panel input[type=file]').setInputFiles({
    name: 'cut.png',
    mimeType: '',
    buffer: pngOf(painted(220, 200, cut)),
  });
  await button(page, 'It is a photo of fabric').click();
  await dialogOf(page).getByRole('img', {name: 'Photo of the fabric'}).waitFor();
});

it(
  'is read on a phone in the dark without a fault that axe could find',
  {tags: ['thorough']},
  async () => {
    const page = await openPage({
      viewport: {width: 390, height: 760},
      colorScheme: 'dark',
    });
    const dialog = await openSheet(page);
    expect(await barriers(page)).toEqual([]);
    await give(page, photograph);
    await found(dialog);
    await tileMade(dialog);
    expect(await barriers(page)).toEqual([]);
    const width = await dialog.evaluate((one) => one.scrollWidth - one.clientWidth);
    expect(width).toBe(0);
  },
);
