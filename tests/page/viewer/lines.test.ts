import type {Page} from 'playwright-core';
import {expect, it} from 'vitest';

import type {Point} from '@/model/geometry/vectors.js';
import type {Pattern} from '@/model/result/result.js';
import {sceneOf, type PatternScene} from '@/scene/scene.js';
import {plainPrint as print, squarePair} from '../../support/garments/two-squares.js';
import {
  colourAt,
  realign,
  screenOf,
  settled,
  show,
  useViewer,
  type Colour,
} from '../../support/page/viewer-page.js';

const openPage = useViewer();
const green: Colour = [43, 147, 88];
const red: Colour = [200, 48, 40];
const outline: Colour = [74, 77, 82];

const twoSquares = (symmetries: Pattern['symmetries'] = []): PatternScene =>
  sceneOf(squarePair({symmetries}), print);

/**
 * Colours across lines at points of a piece: from 10 px left of it to 10 px right, the line in the
 * middle.
 */
async function rowsAcross(
  page: Page,
  scene: PatternScene,
  piece: number,
  points: readonly Point[],
): Promise<Colour[][]> {
  const [dx, dy] = scene.pieces[piece]?.offset ?? [NaN, NaN];
  const places = await page.evaluate(
    (all) => all.map((point) => Viewer.view.screenOf(point)),
    points.map(([x, y]): Point => [x + dx, y + dy]),
  );
  const pixels = await screenOf(page);
  return places.map(([x, y]) =>
    Array.from({length: 21}, (_, k) => colourAt(pixels, Math.floor(x) + k - 10, Math.floor(y))),
  );
}

const across = async (...[page, scene, piece, p]: [Page, PatternScene, number, Point]) =>
  (await rowsAcross(page, scene, piece, [p])).flat();

const count = (colours: readonly Colour[], wanted: Colour): number =>
  colours.filter((colour) => colour.join() === wanted.join()).length;

/** Colours across the seam of a piece, row by row. */
const alongSeam = (page: Page, scene: PatternScene, piece: number): Promise<Colour[][]> =>
  rowsAcross(
    page,
    scene,
    piece,
    // below the mark of the middle
    Array.from({length: 41}, (_, k): Point => [piece === 0 ? 4 : 0, 0.5 + k / 40]),
  );

it('draws seams green and whole where the print meets, red, wider and broken where it misses by far', async () => {
  const page = await openPage();
  const scene = twoSquares();
  await show(page, scene);
  for (const piece of [0, 1]) {
    const good = (await alongSeam(page, scene, piece)).map((row) => count(row, green));
    expect(Math.min(...good)).toBeGreaterThanOrEqual(1);
    await realign(page, [
      {angle: 0, translation: [0, 0]},
      {angle: 0, translation: [-9, 5]}, // off by half a repeat in both directions
    ]);
    const bad = await alongSeam(page, scene, piece);
    expect(count(bad.flat(), green)).toBe(0);
    const reds = bad.map((row) => count(row, red));
    expect(Math.max(...reds)).toBeGreaterThan(Math.max(...good));
    expect(Math.min(...reds)).toBe(0);
    await realign(
      page,
      scene.pieces.map(({alignment}) => alignment),
    );
  }
});

it('draws outlines as wide at every zoom', {tags: ['thorough']}, async () => {
  const page = await openPage();
  const scene = twoSquares();
  await show(page, scene);
  await page.evaluate(async (svg) => {
    Viewer.view.setTile(await Viewer.svgTile(svg));
  }, '<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 1 1"><path fill="#fbfaf8" d="M0 0h1v1h-1z"/></svg>');
  await settled(page);
  const before = await across(page, scene, 0, [0, 2]);
  await page.evaluate(
    ([x, y]) => {
      Viewer.view.zoomBy(2.5, Viewer.view.screenOf([x, y + 2]));
    },
    scene.pieces[0]?.offset ?? [NaN, NaN],
  );
  await settled(page);
  const after = await across(page, scene, 0, [0, 2]);
  const dark = (colours: readonly Colour[]): number =>
    colours.reduce((sum, [r]) => sum + (251 - r) / (251 - outline[0]), 0);
  expect(dark(before)).toBeGreaterThan(1);
  expect(Math.abs(dark(after) - dark(before))).toBeLessThan(0.2);
});

it('draws a mirror axis beyond the outline, and leaves the print alone', async () => {
  const page = await openPage();
  const scene = twoSquares([
    {kind: 'piece', piece: 0, map: {angle: 0, translation: [4, 0]}, pairs: []},
  ]);
  await show(page, scene);
  const [dx, dy] = scene.pieces[0]?.offset ?? [NaN, NaN];
  const [low, high] = await page.evaluate(
    ([x, y]) => [Viewer.view.screenOf([x, y + 0.2]), Viewer.view.screenOf([x, y + 3.8])] as const,
    [dx + 2, dy] as const,
  );
  const pixels = await screenOf(page);
  const inked: boolean[] = [];
  for (let y = Math.ceil(high[1]); y < low[1]; y++) {
    inked.push(colourAt(pixels, Math.floor(low[0]), y)[0] < 120);
  }
  expect(inked).not.toContain(true);
  const beyond: boolean[] = [];
  for (let y = Math.ceil(high[1]) - 40; y < high[1]; y++) {
    beyond.push(colourAt(pixels, Math.floor(low[0]), y)[0] < 120);
  }
  expect(beyond).toContain(true);
});

it('puts the same letter on both pieces of a pair that is pointed at', async () => {
  const page = await openPage();
  await show(
    page,
    twoSquares([{kind: 'pair', pieces: [0, 1], map: {angle: 0, translation: [4, 0]}, pairs: []}]),
  );
  const letters = page.getByText('α', {exact: true});
  await expect.poll(() => letters.count()).toBe(2);
  const shown = () => letters.evaluateAll((all) => all.map((one) => one.checkVisibility()));
  expect(await shown()).toEqual([false, false]);
  for (const overlay of [{hoverPiece: 1}, {allPairs: true}]) {
    await page.evaluate((one) => {
      Viewer.view.setOverlay(one);
    }, overlay);
    await expect.poll(shown).toEqual([true, true]);
    await page.evaluate(() => {
      Viewer.view.setOverlay(undefined);
    });
    await expect.poll(shown).toEqual([false, false]);
  }
});
