/** Several views on a page, and records of their graphics contexts and canvases. */
import type {Page} from 'playwright-core';
import {expect} from 'vitest';

import {decoded, type Pixels} from '../../../web/samples/prints/raster.js';
import type {PatternView} from '../../../web/src/viewer/pattern-view.js';
import {sceneOf, type PatternScene} from '../../../web/src/scene/scene.js';
import {plainPrint as print, squarePair} from '../garments/two-squares.js';
import type {Box} from '../pages/viewer/main.js';
import {checkered, useViewer} from './viewer-page.js';

declare global {
  /** Records since the page was opened. */
  var Seen: {
    readonly contexts: WebGL2RenderingContext[];
    /** Number of copied images per frame, by its time. */
    readonly copies: Map<number, number>;
    /** True for each canvas added to the page with an image. */
    readonly hung: boolean[];
    readonly lost: boolean[];
  };
  var views: PatternView[];
}

export const tile = checkered();

/** Counts contexts and copies, and checks every canvas that is added to the page. */
function watch(): void {
  const seen: typeof Seen = {contexts: [], copies: new Map(), hung: [], lost: []};
  globalThis.Seen = seen;
  type Method = (this: unknown, ...given: unknown[]) => unknown;
  const wrap = (of: object, name: string, wrapper: (method: Method) => Method): void => {
    Reflect.set(of, name, wrapper(Reflect.get(of, name) as Method));
  };
  wrap(
    HTMLCanvasElement.prototype,
    'getContext',
    (getContext) =>
      function (...asked) {
        const context = Reflect.apply(getContext, this, asked) as WebGL2RenderingContext | null;
        if (String(asked[0]).startsWith('webgl') && context && !seen.contexts.includes(context)) {
          seen.contexts.push(context);
        }
        return context;
      },
  );
  let isSampling = false;
  wrap(
    CanvasRenderingContext2D.prototype,
    'drawImage',
    (drawImage) =>
      function (...given) {
        const [source] = given;
        if (!isSampling && seen.contexts.some(({canvas}) => canvas === source)) {
          const now = Number(document.timeline.currentTime);
          seen.copies.set(now, (seen.copies.get(now) ?? 0) + 1);
        }
        return Reflect.apply(drawImage, this, given);
      },
  );
  const sample = (canvas: HTMLCanvasElement): boolean => {
    const one = document.createElement('canvas').getContext('2d');
    isSampling = true;
    one?.drawImage(canvas, 0, 0, 300, 150);
    isSampling = false;
    return one?.getImageData(0, 0, 300, 150).data.some((value) => value > 0) ?? false;
  };
  // runs before the frame is shown
  new MutationObserver((changes) => {
    for (const node of changes.flatMap(({addedNodes}) => [...addedNodes])) {
      if (node instanceof HTMLCanvasElement) seen.hung.push(sample(node));
    }
  }).observe(document, {childList: true, subtree: true});
}

/** The pair of squares with different alignments for each number. */
export const sceneFor = (k: number): PatternScene =>
  sceneOf(squarePair({seams: []}), print, {
    alignments: [
      {angle: 0.2 * k, translation: [0.7 * k, 1.3 * k]},
      {angle: -0.3 * k, translation: [2.1 * k, -0.4 * k]},
    ],
  });

export const frames = (page: Page, count: number): Promise<void> =>
  page.evaluate(async (times) => {
    for (let k = 0; k < times; k++) await new Promise(requestAnimationFrame);
  }, count);

export async function picture(
  page: Page,
  {left = 0, top = 0, width, height}: Box,
): Promise<Pixels> {
  return decoded(await page.screenshot({clip: {x: left, y: top, width, height}}));
}

/** The greatest difference of a colour, from 0 to 255. */
export function difference(a: Pixels, b: Pixels): number {
  expect([a.width, a.height]).toEqual([b.width, b.height]);
  return a.data.reduce((most, value, k) => Math.max(most, Math.abs(value - (b.data[k] ?? 0))), 0);
}

/** Number of colours: a print has many, an empty canvas one. */
export const colours = ({data}: Pixels): number =>
  new Set(Array.from({length: data.length / 4}, (_, k) => data.slice(4 * k, 4 * k + 3).join()))
    .size;

/** A page of 1200 x 600 px with one view. */
export function useManyViews(): () => Promise<Page> {
  const openPage = useViewer();
  return () => openPage({width: 1200, height: 600, before: watch});
}

/** Opens views in boxes, each with a different scene, instead of the first one. */
export async function openViews(page: Page, boxes: readonly Box[]): Promise<void> {
  await page.evaluate(
    async ([places, scenes, png]) => {
      const image = await Viewer.loadTile(png);
      globalThis.views = places.map((box) =>
        Viewer.openView(box, {onLost: (isLost) => Seen.lost.push(isLost)}),
      );
      Viewer.view.dispose();
      views.forEach((view, k) => {
        if (scenes[k]) view.show(scenes[k]);
        view.setTile(image);
      });
    },
    [boxes, boxes.map((_, k) => sceneFor(k)), tile.png] as const,
  );
  await frames(page, 12);
}

export const grid: readonly Box[] = Array.from({length: 24}, (_, k) => ({
  ...{left: (k % 6) * 200, top: Math.floor(k / 6) * 150},
  ...{width: 200, height: 150},
}));
export const pair = grid.slice(0, 2);

/** Numbers of canvases in the boxes that are the renderer's own, and that are copies. */
export const canvases = (page: Page): Promise<{direct: number; copied: number}> =>
  page.evaluate(() => {
    const all = [...document.querySelectorAll('canvas')];
    const direct = all.filter((canvas) => canvas.getContext('webgl2')).length;
    return {direct, copied: all.length - direct};
  });
