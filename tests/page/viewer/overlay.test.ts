import type {Page} from 'playwright-core';
import {expect, it} from 'vitest';

import {decoded, type Pixels} from '@samples/prints/raster.js';
import type {Alignment, Point} from '@/model/geometry/vectors.js';
import {realigned, sceneOf, type PatternScene} from '@/scene/scene.js';
import {plainPrint as print, squarePair} from '../../support/garments/two-squares.js';
import {
  checkered,
  colourAt,
  compared,
  printed,
  screenOf,
  setTile,
  settled,
  show,
  useViewer,
  type Colour,
} from '../../support/page/viewer-page.js';

const openPage = useViewer();
const accent: Colour = [36, 98, 214];

async function opened(scene: PatternScene): Promise<Page> {
  const page = await openPage();
  await show(page, scene);
  return page;
}

/** Number of pixels of a colour on the screen, within some px of a point of a piece. */
async function near(page: Page, scene: PatternScene, piece: number, p: Point): Promise<number> {
  const [dx, dy] = scene.pieces[piece]?.offset ?? [NaN, NaN];
  const at = [p[0] + dx, p[1] + dy] as const;
  const [x, y] = await page.evaluate((point) => Viewer.view.screenOf(point), at);
  const pixels = await screenOf(page);
  let found = 0;
  for (let i = -8; i <= 8; i++) {
    for (let j = -8; j <= 8; j++) {
      const colour = colourAt(pixels, Math.floor(x) + i, Math.floor(y) + j);
      if (colour.join() === accent.join()) found++;
    }
  }
  return found;
}

it('lights up both sides of a seam, and lets go of them', async () => {
  const scene = sceneOf(squarePair(), print);
  const page = await opened(scene);
  await page.evaluate(() => {
    Viewer.view.setOverlay({highlight: {seam: 0, side: 'a'}});
  });
  await settled(page);
  expect(await near(page, scene, 0, [4, 1])).toBeGreaterThan(20);
  expect(await near(page, scene, 1, [0, 1])).toBeGreaterThan(20);
  expect(await near(page, scene, 0, [0, 1])).toBe(0);
  await page.evaluate(() => {
    Viewer.view.setOverlay(undefined);
  });
  await settled(page);
  expect(await near(page, scene, 0, [4, 1])).toBe(0);
});

it('marks points with their names, and says what is wrong at its place', async () => {
  const scene = sceneOf(squarePair(), print);
  const page = await opened(scene);
  await page.evaluate(() => {
    Viewer.view.setOverlay({
      points: [{piece: 0, point: [1, 1], label: 'Start'}],
      message: {piece: 1, point: [2, 2], text: 'Too short', tone: 'error'},
    });
  });
  await settled(page);
  expect(await near(page, scene, 0, [1, 1])).toBeGreaterThan(20);
  const at = async (piece: number, point: Point): Promise<Point> => {
    const [dx, dy] = scene.pieces[piece]?.offset ?? [NaN, NaN];
    return page.evaluate((p) => Viewer.view.screenOf(p), [point[0] + dx, point[1] + dy] as const);
  };
  const [start, place] = [await page.getByText('Start').boundingBox(), await at(0, [1, 1])];
  expect(start?.x).toBeGreaterThan(place[0]);
  expect(Math.abs((start?.y ?? NaN) + (start?.height ?? NaN) / 2 - place[1])).toBeLessThan(2);
  const said = await page.getByText('Too short').boundingBox();
  expect((said?.y ?? NaN) + (said?.height ?? NaN)).toBeLessThan((await at(1, [2, 2]))[1]);
});

it('follows a pointer without building anything else anew', {tags: ['thorough']}, async () => {
  const page = await opened(sceneOf(squarePair(), print));
  const kept = await page.evaluate(() => {
    const name = document.querySelector('main span');
    for (let k = 0; k < 50; k++) {
      Viewer.view.setOverlay({cursors: [{piece: 0, point: [k / 20, 1]}]});
    }
    return name?.isConnected;
  });
  expect(kept).toBe(true);
});

it('shows another scene of the sheet left of a line', {tags: ['thorough']}, async () => {
  const tile = checkered();
  const scene = sceneOf(squarePair({seams: []}), print);
  const before: readonly Alignment[] = scene.pieces.map(() => ({angle: 0.4, translation: [3, 2]}));
  const page = await opened(scene);
  await setTile(page, tile.png);
  await page.evaluate((alignments) => {
    const {scene: now} = Viewer;
    if (now) Viewer.view.setWipe({before: Viewer.realigned(now, alignments), split: 0.5});
  }, before);
  await settled(page);
  // the wearer's left is on the right of the sheet
  const [right, left] = await compared(page, scene, tile.pixels);
  expect(right?.wrong).toEqual([]);
  expect(right?.points).toBeGreaterThan(20);
  expect(left?.wrong.length).toBeGreaterThan(0);
  const [, other] = await compared(page, realigned(scene, before), tile.pixels);
  expect(other?.wrong).toEqual([]);
  expect(other?.points).toBeGreaterThan(20);
  await page.evaluate(() => {
    Viewer.view.setWipe(undefined);
  });
  await settled(page);
  for (const {wrong} of await compared(page, scene, tile.pixels)) expect(wrong).toEqual([]);
});

it('shows bare cloth where a piece has no print', {tags: ['thorough']}, async () => {
  const scene = sceneOf(squarePair({seams: []}), print, {plain: new Set(['right_half'])});
  const page = await opened(scene);
  await setTile(page, checkered().png);
  const pixels = await screenOf(page);
  const colours = async (piece: number): Promise<Set<string>> => {
    const [dx, dy] = scene.pieces[piece]?.offset ?? [NaN, NaN];
    const [x, y] = await page.evaluate((p) => Viewer.view.screenOf(p), [dx + 2, dy + 2] as const);
    const all = Array.from({length: 60}, (_, k) =>
      colourAt(pixels, Math.floor(x) + 2 * k - 60, Math.floor(y) + k - 30).join(),
    );
    return new Set(all);
  };
  expect((await colours(0)).size).toBeGreaterThan(1);
  expect((await colours(1)).size).toBe(1);
});

it(
  'gives a picture of the whole sheet, however the view is zoomed',
  {tags: ['thorough']},
  async () => {
    const tile = checkered();
    const scene = sceneOf(squarePair({seams: []}), print);
    const page = await opened(scene);
    await setTile(page, tile.png);
    const data = await page.evaluate(async () => {
      Viewer.view.zoomBy(5);
      const blob = await Viewer.view.toBlob(1800);
      return [...new Uint8Array(await blob.arrayBuffer())];
    });
    const picture: Pixels = await decoded(Buffer.from(data));
    expect(picture.width).toBe(1800);
    expect(colourAt(picture, 3, 3)).toEqual([251, 250, 248]);
    // 24 CSS px of 900 are the margin on either side
    const scale = (1800 - 96) / scene.size[0];
    const [dx, dy] = scene.pieces[0]?.offset ?? [NaN, NaN];
    for (const p of [
      [1.9, 0.6],
      [0.6, 3.1],
    ] as const) {
      const x = 48 + (p[0] + dx) * scale;
      const y = picture.height / 2 - (p[1] + dy - scene.size[1] / 2) * scale;
      expect(colourAt(picture, Math.floor(x), Math.floor(y))).toEqual(
        printed(print, tile.pixels, {angle: 0, translation: [0, 0]}, p),
      );
    }
  },
);
