/** Two dozen elements on one page: resources they share, release, and keep when they move. */
import {readdirSync} from 'node:fs';

import type {Page} from 'playwright-core';
import {expect, it} from 'vitest';

import {decoded} from '@samples/prints/raster.js';
import {useElementPage} from '../../support/page/element-page.js';
import {isHelper} from '../../support/page/solver-page.js';
import {caughtUp, frames, workersLeft} from '../../support/page/waiting.js';

const openPage = useElementPage();

const garments = readdirSync(new URL('../../../public/garments/', import.meta.url)).filter((name) =>
  name.endsWith('-m.json'),
);
const tags = ['p4m', 'pgg'].flatMap((print) =>
  garments.map(
    (name) =>
      `<seamwise-garment garment="garments/${name}" print="prints/${print}.json"></seamwise-garment>`,
  ),
);

declare global {
  var Contexts: WebGL2RenderingContext[];
}

/** Counts the graphics contexts, on a simulated machine with many cores. */
function watch(): void {
  globalThis.Contexts = [];
  Object.defineProperty(navigator, 'hardwareConcurrency', {value: 16});
  const prototype = HTMLCanvasElement.prototype;
  const make = Reflect.get(prototype, 'getContext') as (...asked: unknown[]) => unknown;
  Reflect.set(prototype, 'getContext', function (this: unknown, ...asked: unknown[]) {
    const context = Reflect.apply(make, this, asked);
    if (context instanceof WebGL2RenderingContext && !Contexts.includes(context)) {
      Contexts.push(context);
    }
    return context;
  });
}

const states = (page: Page): Promise<readonly string[]> =>
  page.evaluate(() => [...document.querySelectorAll('seamwise-garment')].map(({state}) => state));

/** Waits until every element has its drawing on the screen. */
const allDrawn = (page: Page): Promise<unknown> =>
  page.waitForFunction(() =>
    [...document.querySelectorAll('seamwise-garment')].every(
      ({shadowRoot}) => shadowRoot?.querySelector<HTMLElement>('[part=poster]')?.hidden,
    ),
  );

/** Number of colours in each element on the screen; an empty one has few. */
async function coloursOf(page: Page): Promise<readonly number[]> {
  const {data, width} = await decoded(await page.screenshot());
  const boxes = await page.evaluate(() =>
    [...document.querySelectorAll('seamwise-garment')].map((element) => {
      const {left, top, width, height} = element.getBoundingClientRect();
      return [left, top, width, height].map(Math.round) as [number, number, number, number];
    }),
  );
  return boxes.map(([left, top, across, down]) => {
    const seen = new Set<number>();
    for (let y = top; y < top + down; y++) {
      for (let x = left; x < left + across; x++) {
        const at = 4 * (y * width + x);
        seen.add(((data[at] ?? 0) << 16) | ((data[at + 1] ?? 0) << 8) | (data[at + 2] ?? 0));
      }
    }
    return seen.size;
  });
}

it(
  'shows 24 with one graphics context and four workers, each when it is near',
  {tags: ['thorough']},
  async () => {
    const {put, page, asked} = await openPage({
      ...{before: watch, viewport: {width: 1200, height: 720}},
      maySay: /Context (Lost|Restored)|not belong to this context|too many errors/, // three.js logs
    });
    let workers = 0;
    page.on('worker', () => {
      const solving = page.workers().filter((worker) => !isHelper(worker));
      workers = Math.max(workers, solving.length);
    });
    expect(tags).toHaveLength(24);
    await put(`<main>${tags.join('')}</main>`);
    await page.locator('seamwise-garment:state(ready)').first().waitFor();
    await caughtUp(page);
    const near = (await states(page)).filter((state) => state !== 'idle').length;
    expect(near).toBeLessThanOrEqual(2);
    expect(asked.filter((path) => path.startsWith('garments/'))).toHaveLength(near);

    await page.evaluate(() => {
      document.querySelector('main')?.classList.add('grid');
    });
    await page.waitForFunction(
      () => document.querySelectorAll('seamwise-garment:state(ready)').length === 24,
      undefined,
      {timeout: 120_000},
    );
    await allDrawn(page);
    expect(workers).toBeLessThanOrEqual(4);
    expect(workers).toBeGreaterThan(1);
    expect(await page.evaluate(() => Contexts.length)).toBe(1);
    const before = await coloursOf(page);
    expect(Math.min(...before)).toBeGreaterThan(20);

    // context lost and restored, as after a driver restart
    await page.evaluate(async () => {
      const [context] = Contexts;
      const extension = context?.getExtension('WEBGL_lose_context');
      const canvas = context?.canvas as HTMLCanvasElement;
      const heard = (type: string): Promise<unknown> =>
        new Promise((resolve) => {
          canvas.addEventListener(type, resolve, {once: true});
        });
      const lost = heard('webglcontextlost');
      extension?.loseContext();
      await lost;
      for (let k = 0; k < 3; k++) await new Promise(requestAnimationFrame);
      const restored = heard('webglcontextrestored');
      extension?.restoreContext();
      await restored;
      for (let k = 0; k < 12; k++) await new Promise(requestAnimationFrame);
    });
    expect(await coloursOf(page)).toEqual(before);
    expect(await page.evaluate(() => Contexts.length)).toBe(1);

    const held = await page.evaluate(() => heldByCard());
    await page.evaluate(() => {
      for (const one of [...document.querySelectorAll('seamwise-garment')].slice(1)) one.remove();
    });
    const left = () => page.evaluate(() => heldByCard());
    await expect.poll(async () => (await left()).geometries).toBeLessThan(held.geometries / 8);
    await expect.poll(async () => (await left()).textures).toBeLessThan(held.textures / 8);
    await workersLeft(page, 1);
    await page.evaluate(() => document.querySelector('seamwise-garment')?.remove());
    await workersLeft(page, 0);
    expect(await page.evaluate(() => Contexts.every((context) => context.isContextLost()))).toBe(
      true,
    );
  },
);

it(
  'keeps its state wherever it is moved, and asks for nothing again',
  {tags: ['thorough']},
  async () => {
    const {put, page, asked} = await openPage({viewport: {width: 1200, height: 720}});
    const [first = '', second = '', third = ''] = tags;
    await put(`<main class="grid">${first}${second}${third}</main><aside></aside>`);
    await page.waitForFunction(
      () => document.querySelectorAll('seamwise-garment:state(ready)').length === 3,
    );
    await allDrawn(page);
    const before = asked.length;
    await page.clock.install();
    const watched = await page.evaluateHandle(async () => {
      const all = [...document.querySelectorAll('seamwise-garment')];
      const [a, b, c] = all;
      const [main, aside] = [document.querySelector('main'), document.querySelector('aside')];
      if (!a || !b || !c || !main || !aside) throw new Error('They are gone.');
      const results = all.map(({result}) => result);
      const heard: string[] = [];
      for (const one of all) {
        for (const type of ['load', 'progress', 'solve', 'change', 'error'] as const) {
          one.addEventListener(type, () => heard.push(type));
        }
      }
      const look = (): void => {
        const isSame = all.every(
          (one, k) => one.isConnected && one.state === 'ready' && one.result === results[k],
        );
        if (!isSame) heard.push('other');
      };
      const root = aside.attachShadow({mode: 'open'});
      const moves: readonly (readonly [ParentNode, ...Element[]])[] = [
        [main, a],
        [main, c, b],
        [document.body, b],
        [root, a, b],
        [main, b, a],
        [main, c, b, a],
      ];
      for (const [place, ...moved] of moves) {
        for (const frames of [0, 3]) {
          place.append(...moved);
          await Promise.resolve();
          for (let k = 0; k < frames; k++) await new Promise(requestAnimationFrame);
          look();
        }
      }
      for (const one of all) one.remove();
      const back = (): void => {
        main.append(a, b, c);
      };
      return {heard, look, back};
    });
    await page.clock.fastForward(1500); // longer than a move to another place takes
    await watched.evaluate(({back}) => {
      back();
    });
    await frames(page, 3);
    const events = await watched.evaluate(({look, heard}) => {
      look();
      return heard;
    });
    expect(events).toEqual([]);
    await allDrawn(page);
    expect(Math.min(...(await coloursOf(page)))).toBeGreaterThan(20);
    expect(asked.length).toBe(before);
  },
);
