/** Access beyond the panels: skipping to the pattern, dropping files, printing. */
import {expect, it, vi} from 'vitest';

import {sampleOf} from '../../support/level.js';
import {barriers} from '../../support/page/barriers.js';
import {button, showSample, solved, usePage} from '../../support/page/page.js';

vi.setConfig({testTimeout: 180_000}); // a busy machine is slow at everything

const openPage = usePage();

it('leads keyboards to the pattern with the first press of Tab', {tags: ['thorough']}, async () => {
  const page = await openPage();
  await solved(page);
  const skip = button(page, 'To the pattern');
  const top = async (): Promise<number> => (await skip.boundingBox())?.y ?? Number.NaN;
  expect(await top()).toBeLessThan(-20);
  await page.keyboard.press('Tab');
  expect(await top()).toBeGreaterThanOrEqual(0);
  expect(await barriers(page)).toEqual([]);
  await page.keyboard.press('Enter');
  const pattern = page.getByRole('application', {name: 'Pattern'});
  expect(await pattern.evaluate((element) => element.matches(':focus'))).toBe(true);
});

it(
  'shows that a file held over the page would be taken, until it is let go or gone',
  {tags: ['thorough']},
  async () => {
    const page = await openPage();
    await solved(page);
    const hint = page.getByText('Drop to open the file');
    const drag = (type: string, kind: 'file' | 'text'): Promise<void> =>
      page.evaluate(
        ([type, kind]) => {
          const dataTransfer = new DataTransfer();
          if (kind === 'file') dataTransfer.items.add(new File(['{}'], 'empty.json'));
          else dataTransfer.setData('text/plain', 'words');
          const options = {bubbles: true, cancelable: true, dataTransfer};
          document.body.dispatchEvent(new DragEvent(type, options));
        },
        [type, kind] as const,
      );
    await drag('dragover', 'text');
    await expect.poll(() => hint.isVisible()).toBe(false);
    await drag('dragover', 'file');
    await hint.waitFor();
    await drag('dragleave', 'file');
    await hint.waitFor({state: 'hidden'});
    await drag('dragover', 'file');
    await hint.waitFor();
    await drag('drop', 'file');
    await hint.waitFor({state: 'hidden'});
    await page.getByText('empty.json').first().waitFor(); // the file is opened
  },
);

it.each(sampleOf(1, ['light', 'dark'] as const))(
  'prints the pattern alone, on white (%s)',
  {tags: ['thorough']},
  async (theme) => {
    const page = await openPage({colorScheme: theme});
    await showSample(page, 'tee');
    await page.emulateMedia({media: 'print', colorScheme: theme});
    await page.evaluate(() => dispatchEvent(new Event('beforeprint')));
    const sheet = page.locator('canvas.on-paper');
    const {corner, shares} = await sheet.evaluate((canvas: HTMLCanvasElement) => {
      const {width, height} = canvas;
      const {data} = canvas.getContext('2d')?.getImageData(0, 0, width, height) ?? {data: []};
      let whites = 0;
      for (let at = 0; at < data.length; at += 4)
        if ((data[at] ?? 0) + (data[at + 1] ?? 0) + (data[at + 2] ?? 0) === 765) whites++;
      return {corner: [...data.slice(0, 4)], shares: whites / (width * height)};
    });
    expect(corner).toEqual([255, 255, 255, 255]);
    expect(shares).toBeGreaterThan(0.2);
    expect(shares).toBeLessThan(0.9);
    await expect.poll(() => button(page, 'My fabric').isVisible()).toBe(false);
    await expect.poll(() => sheet.isVisible()).toBe(true);
    await page.evaluate(() => dispatchEvent(new Event('afterprint')));
    await page.emulateMedia({media: 'screen', colorScheme: theme});
    await expect.poll(() => sheet.count()).toBe(0);
    await button(page, 'My fabric').waitFor();
  },
);
