/** The element with view="garment": draped on a dummy in its print, and its events. */
import {createHash} from 'node:crypto';

import type {Page} from 'playwright-core';
import {expect, it} from 'vitest';

import type {DrapePane} from '@/editor/drape/drape-pane.js';
import type {SeamwiseGarment} from '@/element/seamwise-garment.js';
import {frames} from '../../support/page/waiting.js';
import {tee, useElementPage} from '../../support/page/element-page.js';

const openPage = useElementPage();
/** Software rendering may have to share a busy machine. */
const patient = {timeout: 60_000};
const worn = tee.replace('alt=', 'view="garment" alt=');

/**
 * Counts events of the elements that match a selector, from now on. @returns a function that
 * returns the count so far
 */
async function counted(page: Page, type: string, selector = '*'): Promise<() => Promise<number>> {
  const count = await page.evaluateHandle(
    ([type, selector]) => {
      const told = {times: 0};
      const hear = ({target}: Event): void => {
        if (target instanceof Element && target.matches(selector)) told.times++;
      };
      document.addEventListener(type, hear, true);
      return told;
    },
    [type, selector] as const,
  );
  return () => count.evaluate(({times}) => times);
}

it('drapes what it shows, tells how far it is, and gives a picture of it from where it is to be seen', async () => {
  const {page, put, run} = await openPage({viewport: {width: 700, height: 600}});
  await page.evaluate(() => {
    const told: unknown[] = [];
    Object.assign(globalThis, {told});
    document.addEventListener('drape', (event) => told.push((event as CustomEvent).detail), true);
  });
  await put(worn);
  await page.waitForFunction(() =>
    (globalThis as unknown as {told: {settled: boolean}[]}).told.some(({settled}) => settled),
  );
  await page.locator('seamwise-garment [part=poster]').waitFor({state: 'hidden'});
  const told = await page.evaluate(
    () => (globalThis as unknown as {told: {fraction: number; settled: boolean}[]}).told,
  );
  expect(told.at(-1)).toEqual({stage: 'done', fraction: 1, settled: true, notes: []});
  expect(told.slice(0, -1).every(({settled, fraction}) => !settled && fraction < 1)).toBe(true);
  /** Shares of the colours of ground and fabric in an image. */
  const seen = async (): Promise<{ground: number; cloth: number; width: number}> =>
    run(async (element: SeamwiseGarment) => {
      const picture = await createImageBitmap(await element.toBlob({width: 300}));
      const context = new OffscreenCanvas(picture.width, picture.height).getContext('2d');
      context?.drawImage(picture, 0, 0);
      const {data} = context?.getImageData(0, 0, picture.width, picture.height) ?? {data: []};
      let [ground, cloth] = [0, 0];
      for (let at = 0; at < data.length; at += 4) {
        const [r = 0, g = 0, b = 0] = [data[at], data[at + 1], data[at + 2]];
        if (r === 251 && g === 250 && b === 248) ground++;
        else if (Math.max(r, g, b) - Math.min(r, g, b) > 40) cloth++;
      }
      const all = data.length / 4;
      return {ground: ground / all, cloth: cloth / all, width: picture.width};
    });
  const shown = await seen();
  expect(shown.width).toBe(300);
  expect(shown.ground).toBeGreaterThan(0.3);
  expect(shown.cloth).toBeGreaterThan(0.005);
  await run((element) => {
    element.dummy = 'hidden';
    element.camera = 'back';
  });
  await expect.poll(async () => (await seen()).ground, patient).toBeGreaterThan(shown.ground);
});

it(
  'is turned by keys, says what is seen, and comes back after the graphics were away',
  {tags: ['thorough']},
  async () => {
    const {page, put, run} = await openPage({
      maySay: /Context (Lost|Restored)/,
      viewport: {width: 700, height: 600},
    });
    await put(worn);
    await page.locator('seamwise-garment [part=poster]').waitFor({state: 'hidden'});
    const garment = page.getByRole('application', {name: 'Garment, worn'});
    const status = page.locator('seamwise-garment sw-drape-pane [role=status]');
    await expect.poll(() => status.textContent(), patient).toContain('Front view.');
    await expect
      .poll(() => status.textContent(), patient)
      .toMatch(/ (All \d+|\d+ of \d+) visible seams match\.$/);
    await garment.focus();
    await page.keyboard.press('2');
    await expect.poll(() => status.textContent(), patient).toContain('Back view.');
    for (let k = 0; k < 6; k++) await page.keyboard.press('ArrowRight');
    await expect.poll(() => status.textContent(), patient).toContain('View from the right.');
    await page.evaluate(() => {
      const deep = document
        .querySelector('seamwise-garment')
        ?.shadowRoot?.querySelector('sw-drape-pane');
      const extension = deep?.shadowRoot
        ?.querySelector('canvas')
        ?.getContext('webgl2')
        ?.getExtension('WEBGL_lose_context');
      extension?.loseContext();
      setTimeout(() => extension?.restoreContext(), 300);
    });
    await expect
      .poll(
        () => run((element) => element.toBlob({width: 80}).then(() => 'drawn', String)),
        patient,
      )
      .toBe('drawn');
  },
);

it('is turned by one finger, and moved and zoomed by two', {tags: ['thorough']}, async () => {
  const {page, put, run} = await openPage({viewport: {width: 700, height: 600}, hasTouch: true});
  await put(worn);
  await page.locator('seamwise-garment [part=poster]').waitFor({state: 'hidden'});
  const box = await page.locator('seamwise-garment').boundingBox();
  if (!box) throw new Error('The element has no place.');
  const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
  const touch = await page.context().newCDPSession(page);
  const fingers = (type: string, ...points: (readonly [number, number])[]): Promise<unknown> =>
    touch.send('Input.dispatchTouchEvent', {
      type: type as 'touchStart',
      touchPoints: points.map(([dx, dy], id) => ({x: x + dx, y: y + dy, id})),
    });
  const status = page.locator('seamwise-garment sw-drape-pane [role=status]');
  await expect.poll(() => status.textContent(), patient).toContain('Front view.');
  await fingers('touchStart', [0, 0]);
  for (let k = 1; k <= 8; k++) await fingers('touchMove', [-30 * k, 0]);
  await fingers('touchEnd');
  await expect.poll(() => status.textContent(), patient).toContain('View from the left.');
  const seen = (): Promise<string> => page.locator('seamwise-garment').screenshot().then(String);
  const turned = await seen();
  await fingers('touchStart', [-40, 0]);
  await fingers('touchStart', [-40, 0], [40, 0]);
  for (let k = 1; k <= 5; k++)
    await fingers('touchMove', [-40 - 8 * k, 6 * k], [40 + 8 * k, 6 * k]);
  await fingers('touchEnd');
  await expect.poll(seen, patient).not.toBe(turned);
  await expect.poll(() => status.textContent(), patient).toContain('View from the left.');
  expect(await page.evaluate(() => scrollY)).toBe(0);
  expect(await run((element) => element.state)).toBe('ready');
});

it('drapes nothing that nobody sees', {tags: ['thorough']}, async () => {
  const {page, put} = await openPage({viewport: {width: 700, height: 600}});
  const told = await counted(page, 'drape', 'p *');
  await put(`${'<br>'.repeat(200)}<p>${worn.replace('alt=', 'loading="eager" alt=')}</p>`);
  await page.locator('seamwise-garment:state(ready)').waitFor();
  await frames(page, 3);
  // another garment is draped after all requests so far
  await page.evaluate((markup) => {
    Object.assign(globalThis, {
      settled: new Promise<void>((resolve) => {
        const hear = (event: Event): void => {
          if ((event as CustomEvent<{settled: boolean}>).detail.settled) resolve();
        };
        document.addEventListener('drape', hear, true);
      }),
    });
    document.body.insertAdjacentHTML('afterbegin', `<aside>${markup}</aside>`);
  }, worn);
  await page.evaluate(() => (globalThis as unknown as {settled: Promise<void>}).settled);
  expect(await told()).toBe(0);
  await page.locator('p seamwise-garment').scrollIntoViewIfNeeded();
  await expect.poll(told, patient).toBeGreaterThan(0);
});

it(
  'is of a fabric that its design keeps, without being solved for it again',
  {tags: ['thorough']},
  async () => {
    const {page, put, run} = await openPage({viewport: {width: 700, height: 600}});
    const solved = await counted(page, 'solve');
    await put(worn.replace('alt=', 'fabric="denim" alt='));
    await page.locator('seamwise-garment:state(ready)').waitFor();
    const stored = await run((element) => element.getDesign());
    expect(stored.fabric).toBe('denim');
    await run((element) => {
      element.fabric = 'poplin';
    });
    expect(await run((element) => element.getDesign().fabric)).toBe('poplin');
    expect(await run((element) => element.state)).toBe('ready');
    await run((element, design) => element.setDesign(design), stored);
    expect(await run((element) => element.fabric)).toBe('denim');
    expect(await solved()).toBe(2);
  },
);

it('is drawn as finely after it has moved as before', {tags: ['thorough']}, async () => {
  const {page, put} = await openPage({
    viewport: {width: 600, height: 450},
    reducedMotion: 'no-preference',
  });
  await page.clock.install();
  await put(worn);
  await page.locator('seamwise-garment [part=poster]').waitFor({state: 'hidden'});
  const garment = page.getByRole('application', {name: 'Garment, worn'});
  const status = page.locator('seamwise-garment sw-drape-pane [role=status]');
  await expect.poll(() => status.textContent(), patient).toMatch(/at .+\.$/);
  const stage = page.locator('seamwise-garment sw-drape-pane .stage');
  const picture = async (): Promise<string> =>
    createHash('sha256')
      .update(await stage.screenshot())
      .digest('hex');
  /** Waits until the view is drawn finely at rest. */
  const rest = async (): Promise<void> => {
    await frames(page);
    await page.clock.fastForward(3000);
    await frames(page);
  };
  await garment.focus();
  await page.keyboard.press('1');
  await rest();
  const rested = await picture();
  await page.keyboard.press('2');
  await expect.poll(() => status.textContent(), patient).toContain('Back view.');
  await page.evaluate(() => {
    const {view} =
      document
        .querySelector('seamwise-garment')
        ?.shadowRoot?.querySelector<DrapePane>('sw-drape-pane') ?? {};
    view?.camera.setTurntable(true);
  });
  await rest();
  expect(await picture()).not.toBe(rested);
  await page.keyboard.press('1');
  await expect.poll(picture, patient).toBe(rested);
});
