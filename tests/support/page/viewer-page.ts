/** The pattern view in a browser, and the expected look of a print in it. */
import {createCanvas} from '@napi-rs/canvas';
import type {Browser, Page} from 'playwright-core';
import {afterAll, afterEach, beforeAll, expect, vi} from 'vitest';

import {decoded, type Pixels} from '@samples/prints/raster.js';
import {
  between,
  coordinates,
  distance,
  nearestShare,
  onPrint,
  type Alignment,
  type Point,
} from '@/model/geometry/vectors.js';
import type {Print} from '@/model/print/repeating-print.js';
import {imageCell} from '@/model/print/wallpaper.js';
import {isInside} from '@/model/geometry/polyline.js';
import {pick} from '@/scene/marks.js';
import type {PatternScene, ScenePiece} from '@/scene/scene.js';
import {openBrowser, sourcesOf} from './browser.js';

/** Software rendering may have to share a busy machine. [ms] */
const patience = 180_000;

interface Window {
  readonly width?: number;
  readonly height?: number;
  /** Device pixels per CSS pixel. */
  readonly ratio?: number;
  /** Runs in the page before anything else. */
  readonly before?: () => void;
}

/**
 * Opens the browser once for a test file; no page may report an error. @returns a function that
 * opens the page in a fresh state
 */
export function useViewer(): (window?: Window) => Promise<Page> {
  let browser: Browser | undefined;
  let pages: Page[] = [];
  const errors: string[] = [];
  vi.setConfig({testTimeout: patience});
  beforeAll(async () => {
    browser = await openBrowser();
  });
  afterEach(async () => {
    await Promise.all(pages.map((page) => page.close()));
    pages = [];
    expect(errors.splice(0)).toEqual([]);
  });
  afterAll(() => browser?.close());
  return async ({width = 900, height = 600, ratio = 1, before} = {}) => {
    if (!browser) throw new Error('The browser is not open yet.');
    const page = await browser.newPage({viewport: {width, height}, deviceScaleFactor: ratio});
    pages.push(page);
    page.setDefaultTimeout(patience);
    page.on('pageerror', ({message}) => errors.push(message));
    page.on('console', (message) => {
      if (message.type() === 'error') errors.push(message.text());
    });
    if (before) await page.addInitScript(before);
    await page.goto(sourcesOf('viewer'));
    await page.waitForFunction(() => 'Viewer' in globalThis);
    return page;
  };
}

/** Retries until the result is right. */
export const eventually = <T>(ask: () => Promise<T>) => expect.poll(ask, {timeout: 30_000});

/** Waits until all requested changes are on the screen. */
export const settled = (page: Page): Promise<void> =>
  page.evaluate(async () => {
    // a readback may have started further work
    for (let quiet = 0; quiet < 3; quiet = Viewer.reading > 0 ? 0 : quiet + 1) {
      await new Promise(requestAnimationFrame);
    }
  });

export async function show(page: Page, scene: PatternScene): Promise<void> {
  await page.evaluate((plain) => {
    Viewer.scene = plain;
    Viewer.view.show(plain);
  }, scene);
  await settled(page);
}

/** Shows the same scene with other alignments. */
export async function realign(page: Page, alignments: readonly Alignment[]): Promise<void> {
  await page.evaluate((next) => {
    if (!Viewer.scene) return;
    Viewer.scene = Viewer.realigned(Viewer.scene, next);
    Viewer.view.show(Viewer.scene);
  }, alignments);
  await settled(page);
}

/** A tile of 8 x 8 flat fields of different colours. */
export function checkered(): {readonly png: string; readonly pixels: Pixels} {
  const field = 20;
  const canvas = createCanvas(8 * field, 8 * field);
  const context = canvas.getContext('2d');
  for (let i = 0; i < 8; i++) {
    for (let j = 0; j < 8; j++) {
      context.fillStyle = `rgb(${10 + 33 * i} ${13 + 31 * j} ${(i * 97 + j * 41) % 256})`;
      context.fillRect(i * field, j * field, field, field);
    }
  }
  const {width, height, data} = context.getImageData(0, 0, 8 * field, 8 * field);
  return {png: canvas.toDataURL('image/png'), pixels: {width, height, data}};
}

export async function setTile(page: Page, url: string): Promise<void> {
  await page.evaluate(async (from) => {
    Viewer.view.setTile(await Viewer.loadTile(from));
  }, url);
  await settled(page);
}

export type Colour = readonly [number, number, number];

export function colourAt({width, data}: Pixels, x: number, y: number): Colour {
  const at = 4 * (width * y + x);
  return [data[at] ?? NaN, data[at + 1] ?? NaN, data[at + 2] ?? NaN];
}

/** Screenshot of the page. */
export const screenOf = async (page: Page): Promise<Pixels> => decoded(await page.screenshot());

/** The colour of a tile under a point of a piece that is aligned with the print by p = R w + t. */
export function printed(print: Print, tile: Pixels, alignment: Alignment, p: Point): Colour {
  const [u, v] = coordinates(imageCell(print), onPrint(alignment, p));
  const column = Math.floor((u - Math.floor(u)) * tile.width);
  const row = Math.floor((Math.ceil(v) - v) * tile.height);
  return colourAt(tile, Math.min(column, tile.width - 1), Math.min(row, tile.height - 1));
}

function clearance({points, outline, holes}: ScenePiece, p: Point): number {
  return Math.min(
    ...[outline, ...holes].flatMap((loop) => {
      const line = pick(points, loop);
      return line.map((a, k) => {
        const b = line[(k + 1) % line.length] ?? a;
        return distance(p, between(a, b, nearestShare(a, b, p)));
      });
    }),
  );
}

/**
 * Points inside a piece, away from its lines, with one colour of the tile for `room` around. [cm]
 */
function flatPoints(scene: PatternScene, piece: ScenePiece, tile: Pixels, room: number): Point[] {
  const loop = pick(piece.points, piece.outline);
  const holes = piece.holes.map((hole) => pick(piece.points, hole));
  const [left, right] = [Math.min(...loop.map(([x]) => x)), Math.max(...loop.map(([x]) => x))];
  const [low, high] = [Math.min(...loop.map(([, y]) => y)), Math.max(...loop.map(([, y]) => y))];
  const around = Array.from({length: 60}, (_, k): Point => {
    const [radius, turn] = [(room * Math.ceil((k + 1) / 12)) / 5, (k * Math.PI) / 6];
    return [radius * Math.cos(turn), radius * Math.sin(turn)];
  });
  const colour = (p: Point): string => printed(scene.print, tile, piece.alignment, p).join();
  const found: Point[] = [];
  const steps = 40;
  for (let i = 1; i < steps; i++) {
    for (let j = 1; j < steps; j++) {
      const p: Point = [left + ((right - left) * i) / steps, low + ((high - low) * j) / steps];
      if (!isInside(loop, p) || holes.some((hole) => isInside(hole, p))) continue;
      if (clearance(piece, p) < 3 * room) continue;
      if (around.every(([x, y]) => colour([p[0] + x, p[1] + y]) === colour(p))) found.push(p);
    }
  }
  return found;
}

/** Per piece, the points where screen and tile were compared, and those where they differ. */
export async function compared(
  page: Page,
  scene: PatternScene,
  tile: Pixels,
): Promise<
  readonly {readonly name: string; readonly points: number; readonly wrong: readonly string[]}[]
> {
  const pixels = await screenOf(page);
  const {scale, ratio} = await page.evaluate(() => ({
    scale: Viewer.view.scale,
    ratio: devicePixelRatio,
  }));
  return Promise.all(
    scene.pieces.map(async (piece) => {
      const flat = flatPoints(scene, piece, tile, 5 / (scale * ratio));
      const onSheet = flat.map(([x, y]): Point => [x + piece.offset[0], y + piece.offset[1]]);
      const onScreen = await page.evaluate(
        (points) => points.map((point) => Viewer.view.screenOf(point)),
        onSheet,
      );
      const wrong: string[] = [];
      let points = 0;
      flat.forEach((p, k) => {
        const [x, y] = (onScreen[k] ?? [NaN, NaN]).map((side) => Math.floor(side * ratio)) as [
          number,
          number,
        ];
        if (!(x >= 0 && y >= 0 && x < pixels.width && y < pixels.height)) return;
        points++;
        const [is, should] = [
          colourAt(pixels, x, y).join(),
          printed(scene.print, tile, piece.alignment, p).join(),
        ];
        if (is !== should)
          wrong.push(`(${p.map((c) => c.toFixed(2)).join(', ')}): ${is}, not ${should}`);
      });
      return {name: piece.name, points, wrong};
    }),
  );
}
