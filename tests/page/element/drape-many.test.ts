/** Two dozen draped garments on one page, and one in a tab in the background or hidden. */
import {readdirSync} from 'node:fs';

import {expect, it} from 'vitest';

import {frames} from '../../support/page/waiting.js';
import {tee, useElementPage} from '../../support/page/element-page.js';
import {isHelper} from '../../support/page/solver-page.js';

const openPage = useElementPage();
const patient = {timeout: 120_000};

const garments = readdirSync(new URL('../../../public/garments/', import.meta.url)).filter((name) =>
  name.endsWith('-m.json'),
);
const tags = ['p4m', 'pgg'].flatMap((print) =>
  garments.map(
    (name) =>
      `<seamwise-garment view="garment" garment="garments/${name}" print="prints/${print}.json"></seamwise-garment>`,
  ),
);

declare global {
  var drawn: number;
  var worn: {readonly contexts: Set<unknown>; readonly draped: Set<Element>; settled: number};
}

/** Counts graphics contexts and draping elements, on a simulated machine with many cores. */
function watch(): void {
  globalThis.worn = {contexts: new Set(), draped: new Set(), settled: 0};
  Object.defineProperty(navigator, 'hardwareConcurrency', {value: 16});
  const prototype = HTMLCanvasElement.prototype;
  const make = Reflect.get(prototype, 'getContext') as (...asked: unknown[]) => unknown;
  Reflect.set(prototype, 'getContext', function (this: unknown, ...asked: unknown[]) {
    const context = Reflect.apply(make, this, asked);
    if (context instanceof WebGL2RenderingContext) worn.contexts.add(context);
    return context;
  });
  document.addEventListener(
    'drape',
    (event) => {
      worn.draped.add(event.target as Element);
      if ((event as CustomEvent<{settled: boolean}>).detail.settled) worn.settled++;
    },
    true,
  );
}

const moving = {before: watch, reducedMotion: 'no-preference'} as const;

it(
  'shares one graphics context and one worker that drapes, and drapes those in view',
  {tags: ['thorough']},
  async () => {
    const {put, page} = await openPage({...moving, viewport: {width: 1200, height: 720}});
    let workers = 0;
    page.on('worker', () => {
      workers = Math.max(workers, page.workers().filter((one) => !isHelper(one)).length);
    });
    /** Number of workers that have loaded the drape's module. */
    let drapers = 0;
    page.context().on('request', (request) => {
      if (request.url().endsWith('.wasm') && request.url().includes('drape')) drapers++;
    });
    expect(tags).toHaveLength(24);
    await put(`<main>${tags.join('')}</main>`);
    await page.waitForFunction(() => worn.settled > 0, undefined, patient);
    await page.waitForFunction(
      () =>
        [...document.querySelectorAll('seamwise-garment')]
          .filter((one) => one.getBoundingClientRect().top < innerHeight)
          .every((one) => worn.draped.has(one)),
      undefined,
      patient,
    );
    await frames(page);
    const inView = await page.evaluate(
      () =>
        [...document.querySelectorAll('seamwise-garment')].filter(
          (one) => one.getBoundingClientRect().top < innerHeight,
        ).length,
    );
    expect(await page.evaluate(() => worn.draped.size)).toBeLessThanOrEqual(inView);
    expect(inView).toBeLessThan(24);
    await page.locator('seamwise-garment').last().scrollIntoViewIfNeeded();
    await page.waitForFunction(
      () => worn.draped.has([...document.querySelectorAll('seamwise-garment')].at(-1) as Element),
      undefined,
      patient,
    );
    expect(await page.evaluate(() => worn.draped.size)).toBeLessThan(24);
    expect(await page.evaluate(() => worn.contexts.size)).toBe(1);
    expect(workers).toBeLessThanOrEqual(5); // four that solve, one that drapes
    expect(drapers).toBe(1);
  },
);

it(
  'settles in a tab that is put away, and is drawn once it is back',
  {tags: ['thorough']},
  async () => {
    const {put, page, run} = await openPage({...moving, viewport: {width: 700, height: 600}});
    await put(tee.replace('alt=', 'view="garment" alt='));
    await page.waitForFunction(() => worn.draped.size > 0, undefined, patient);
    const browser = await page.context().newCDPSession(page);
    await browser.send('Page.setWebLifecycleState', {state: 'frozen'});
    await new Promise((resolve) => setTimeout(resolve, 2000));
    await browser.send('Page.setWebLifecycleState', {state: 'active'});
    await page.waitForFunction(() => worn.settled > 0, undefined, patient);
    await page.locator('seamwise-garment [part=poster]').waitFor({state: 'hidden'});
    const picture = await page.locator('seamwise-garment').screenshot();
    expect(picture.length).toBeGreaterThan(10_000);
    expect(await run((element) => element.state)).toBe('ready');
  },
);

/** Counts draw calls from now on. */
function watchDrawing(): void {
  Object.assign(globalThis, {drawn: 0});
  const prototype = WebGL2RenderingContext.prototype;
  const draw = Reflect.get(prototype, 'drawElements') as (...given: unknown[]) => unknown;
  Reflect.set(prototype, 'drawElements', function (this: unknown, ...given: unknown[]) {
    globalThis.drawn++;
    return Reflect.apply(draw, this, given);
  });
}

it(
  'draws nothing while the document is hidden, nor turns, and shows the settled garment afterwards',
  {tags: ['thorough']},
  async () => {
    const {put, page} = await openPage({...moving, viewport: {width: 700, height: 600}});
    await page.evaluate(watchDrawing);
    const show = (state: DocumentVisibilityState): Promise<void> =>
      page.evaluate((visibilityState) => {
        Object.defineProperty(document, 'visibilityState', {
          ...{value: visibilityState, configurable: true},
        });
        document.dispatchEvent(new Event('visibilitychange'));
      }, state);
    const draws = (): Promise<number> => page.evaluate(() => globalThis.drawn);
    await put(tee.replace('alt=', 'view="garment" turntable alt='));
    await page.waitForFunction(
      () => worn.draped.size > 0 && globalThis.drawn > 0,
      undefined,
      patient,
    );
    await show('hidden');
    const before = await draws();
    await page.waitForFunction(() => worn.settled > 0, undefined, patient);
    await frames(page, 30);
    expect(await draws()).toBe(before);
    await show('visible');
    await expect.poll(draws, patient).toBeGreaterThan(before + 50); // it turns again
  },
);
