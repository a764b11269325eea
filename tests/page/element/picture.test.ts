import {sampleOf} from '../../support/level.js';
/** Drawings and images of an element, also after the browser loses the graphics context. */
import {expect, it} from 'vitest';

import {frames} from '../../support/page/waiting.js';
import {tee, useElementPage} from '../../support/page/element-page.js';

const openPage = useElementPage();

/** Outcomes of requests for images of these widths. */
const asked = async (
  {run}: Awaited<ReturnType<typeof openPage>>,
  widths: readonly number[],
): Promise<readonly string[]> =>
  run(async (element, all) => {
    const heard: string[] = [];
    for (const width of all) {
      const one = await element.toBlob({width}).then(
        async (blob) => String((await createImageBitmap(blob)).width),
        (error: unknown) => {
          const {code, message} = error as {code: string; message: string};
          return `${code}: ${message}`;
        },
      );
      heard.push(one);
    }
    return heard;
  }, widths);

it(
  'refuses a picture of a width that there cannot be, and says which there can',
  {tags: ['thorough']},
  async () => {
    const open = await openPage();
    await open.put(tee);
    await open.page.locator('seamwise-garment:state(ready)').waitFor();
    await open.page.locator('seamwise-garment [part=poster]').waitFor({state: 'hidden'});
    const heard = await asked(open, [1, 301.4, 0, -1, NaN, Infinity, 1e6]);
    const [, widest] = /1 to (\d+) pixels/.exec(heard[2] ?? '') ?? [];
    const refused = `options: A picture is 1 to ${String(widest)} pixels wide; choose a width in that range.`;
    expect(heard).toEqual(['1', '301', refused, refused, refused, refused, refused]);
    expect(Number(widest)).toBeGreaterThan(4000);
    expect(Number(widest)).toBeLessThanOrEqual(8192);
  },
);

it.each(sampleOf(1, ['preview', 'edit']))(
  'is a picture of the answer as soon as it is there, with mode="%s"',
  {tags: ['thorough']},
  async (mode) => {
    const open = await openPage({viewport: {width: 1300, height: 800}});
    await open.put(tee.replace('alt=', `mode="${mode}" alt=`));
    await open.page.locator('seamwise-garment:state(ready)').waitFor();
    await open.page.locator('seamwise-garment [part=poster]').waitFor({state: 'hidden'});
    await open.page.clock.install();
    const pictures = await open.page.evaluateHandle(async () => {
      const element = document.querySelector('seamwise-garment');
      if (!element) throw new Error('It is gone.');
      const pixels = async (): Promise<Uint8ClampedArray> => {
        const bitmap = await createImageBitmap(await element.toBlob({width: 200}));
        const {width, height} = bitmap;
        const context = new OffscreenCanvas(width, height).getContext('2d');
        if (!context) throw new Error('There is no canvas.');
        context.drawImage(bitmap, 0, 0);
        return context.getImageData(0, 0, width, height).data;
      };
      /** Mean absolute difference of all values. */
      const difference = (a: Uint8ClampedArray, b: Uint8ClampedArray): number =>
        a.reduce((sum, value, k) => sum + Math.abs(value - (b[k] ?? 0)), 0) / a.length;
      const before = await pixels();
      element.print = 'prints/cm.json';
      await element.solve();
      return {before, atOnce: await pixels(), pixels, difference};
    });
    await frames(open.page);
    await open.page.clock.fastForward(1500); // all movement has ended
    await frames(open.page);
    const differences = await pictures.evaluate(async ({before, atOnce, pixels, difference}) => {
      const later = await pixels();
      return {fromBefore: difference(before, atOnce), fromLater: difference(later, atOnce)};
    });
    expect(differences.fromBefore).toBeGreaterThan(4);
    expect(differences.fromLater).toBeLessThan(4); // an SVG gets a higher resolution at rest
  },
);

it.each(sampleOf(1, ['edit', 'preview', 'place']))(
  'says with mode="%s" when the graphics context is taken away for good, and draws again when it is not',
  {tags: ['thorough']},
  async (mode) => {
    const open = await openPage({
      maySay: /Context (Lost|Restored)/,
      viewport: {width: 1300, height: 800},
    });
    const {page, run} = open;
    await page.evaluate(() => {
      const told: string[] = [];
      Object.assign(globalThis, {told});
      const hear = ({detail}: Event & {detail?: {code: string}}): void => {
        told.push(detail?.code ?? '');
      };
      document.addEventListener('error', hear, true);
    });
    await open.put(tee.replace('alt=', `mode="${mode}" alt=`));
    await page.locator('seamwise-garment:state(ready)').waitFor();
    const tag = {preview: 'sw-drawing', place: 'sw-pattern', edit: 'sw-pattern'}[mode] ?? '';
    const canvas = page.locator(`seamwise-garment ${tag} canvas`).first();
    await canvas.waitFor();
    await expect.poll(async () => asked(open, [50])).toEqual(['50']);
    await canvas.evaluate((one: HTMLCanvasElement) => {
      const extension = one.getContext('webgl2')?.getExtension('WEBGL_lose_context');
      Object.assign(globalThis, {extension});
      extension?.loseContext();
    });
    const told = (): Promise<string[]> =>
      page.evaluate(() => (globalThis as unknown as {told: string[]}).told);
    await expect.poll(told, {timeout: 20_000}).toEqual(['no-webgl']);
    expect(await asked(open, [50])).toEqual([
      expect.stringMatching(/^no-webgl: The browser has taken the graphics away .*\.$/),
    ]);
    const isShown = await run(async (element) => {
      await element.updateComplete;
      const poster = element.shadowRoot?.querySelector<HTMLElement>('[part=poster]');
      return poster?.hidden === false;
    });
    expect(isShown).toBe(mode !== 'edit'); // the editor shows a message instead
    if (mode === 'edit') await page.getByText('The browser has taken the graphics away').waitFor();
    await expect.poll(() => canvas.isVisible()).toBe(false);
    expect(await run(({state}) => state)).toBe('ready');
    await page.evaluate(() => {
      (globalThis as unknown as {extension: WEBGL_lose_context}).extension.restoreContext();
    });
    await expect.poll(async () => asked(open, [50]), {timeout: 20_000}).toEqual(['50']);
    await expect.poll(() => canvas.isVisible()).toBe(true);
    expect(await told()).toEqual(['no-webgl']);
  },
);
