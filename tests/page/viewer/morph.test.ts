import type {Page} from 'playwright-core';
import {expect, it} from 'vitest';

import type {Pixels} from '@samples/prints/raster.js';
import type {Alignment, Point} from '@/model/geometry/vectors.js';
import {sceneOf, type PatternScene} from '@/scene/scene.js';
import {
  plainPrint as print,
  square,
  squarePair,
  squarePiece,
} from '../../support/garments/two-squares.js';
import {difference} from '../../support/page/many-views.js';
import {
  checkered,
  colourAt,
  printed,
  screenOf,
  setTile,
  settled,
  useViewer,
} from '../../support/page/viewer-page.js';

const openPage = useViewer();
const tile = checkered();
const still: Alignment = {angle: 0, translation: [0, 0]};

/** The left half is `wider` cm wider on its left than drafted, and has this alignment. */
function scene(wider: number, alignment = still): PatternScene {
  const shape = square.map(([x, y]): Point => [x === 0 ? -wider : x, y]);
  const [, right = squarePiece('right_half')] = squarePair().pieces;
  return sceneOf(squarePair({pieces: [squarePiece('left_half', {shape}), right]}), print, {
    alignments: [alignment, right.alignment],
  });
}

/** The page's clock only advances explicitly. */
async function openStill(): Promise<Page> {
  const page = await openPage({
    before: () => {
      performance.now = () => Number(document.documentElement.dataset.now ?? 0);
    },
  });
  await showMoving(page, scene(0), 'none');
  await setTile(page, tile.png);
  await page.evaluate(() => {
    Viewer.view.zoomBy(0.5); // room around the pieces
  });
  await settled(page);
  return page;
}

async function showMoving(
  page: Page,
  next: PatternScene,
  motion: 'none' | 'shapes' | 'all' = 'all',
): Promise<void> {
  await page.evaluate(
    ([plain, how]) => {
      Viewer.view.show(plain, how);
    },
    [next, motion] as const,
  );
  await settled(page);
}

async function at(page: Page, ms: number): Promise<Pixels> {
  await page.evaluate((now) => {
    document.documentElement.dataset.now = String(now);
    Viewer.view.panBy(0, 0); // forces a frame
  }, ms);
  await settled(page);
  return screenOf(page);
}

/**
 * Extra width of the drawn left half over the drafted one: its edge begins at the end of the page's
 * background. [cm]
 */
async function widthIn(page: Page, pixels: Pixels): Promise<number> {
  const {row, edge, scale} = await page.evaluate(
    ([dx, dy]) => {
      const [x, y] = Viewer.view.screenOf([dx, dy + 2.1]);
      return {row: Math.round(y), edge: x, scale: Viewer.view.scale};
    },
    scene(0).pieces[0]?.offset ?? [NaN, NaN],
  );
  const gap = Math.round(edge - 1.3 * scale);
  const background = colourAt(pixels, gap, row).join();
  let x = gap;
  while (colourAt(pixels, x, row).join() === background) x++;
  return (edge - x) / scale;
}

it(
  'moves an outline and the fabric to their new place in 200 ms, and ends exactly there',
  {tags: ['thorough']},
  async () => {
    const page = await openStill();
    const drafted = await widthIn(page, await screenOf(page));
    await showMoving(page, scene(1, {angle: 0, translation: [1, 0.5]}));
    const widths: number[] = [];
    for (const ms of [0, 40, 100, 190])
      widths.push((await widthIn(page, await at(page, ms))) - drafted);
    const [start = NaN, ...way] = widths;
    expect(start).toBeCloseTo(0, 1);
    for (const [k, width] of way.entries()) {
      expect(width).toBeGreaterThan((widths[k] ?? NaN) + 0.01);
      expect(width).toBeLessThan(1);
    }
    const end = await at(page, 201);
    expect((await widthIn(page, end)) - drafted).toBeCloseTo(1, 1);
    const plain = await openStill();
    await showMoving(plain, scene(1, {angle: 0, translation: [1, 0.5]}), 'none');
    expect(difference(end, await at(plain, 201))).toBe(0);
  },
);

it(
  'slides the print the shortest way to where it looks the same as asked for',
  {tags: ['thorough']},
  async () => {
    const page = await openStill();
    const [offset = [NaN, NaN]] = scene(0).pieces.map((piece) => piece.offset);
    // 13 cm of a repeat of 10 cm look like 3 cm
    await showMoving(page, scene(0, {angle: 2 * Math.PI, translation: [13, 0]}));
    await at(page, 0);
    const pixels = await at(page, 60);
    const share = 1 - (1 - 60 / 200) ** 3;
    const under = (point: Point, by: number): string =>
      printed(print, tile.pixels, {angle: 0, translation: [by, 0]}, point).join();
    const points = Array.from({length: 12}, (_, k): Point => [0.5 + (k % 4) * 0.9, 0.6 + k * 0.25]);
    let told = 0;
    for (const point of points) {
      // only in the middle of a field of the tile, for the possible range of colours
      const fields = [-0.1, 0, 0.1].map((by) => under(point, 3 * share + by));
      if (new Set(fields).size > 1) continue;
      const place = await page.evaluate((sheet) => Viewer.view.screenOf(sheet), [
        point[0] + offset[0],
        point[1] + offset[1],
      ] as Point);
      const [x, y] = place.map(Math.round);
      expect(colourAt(pixels, x ?? NaN, y ?? NaN).join()).toBe(fields[0]);
      if (fields[0] !== under(point, 3) && fields[0] !== under(point, 0)) told++;
    }
    expect(told).toBeGreaterThan(0);
  },
);

it('goes on from where it is when a newer answer arrives', {tags: ['thorough']}, async () => {
  const page = await openStill();
  const drafted = await widthIn(page, await screenOf(page));
  await showMoving(page, scene(1));
  await at(page, 0);
  const before = (await widthIn(page, await at(page, 60))) - drafted;
  await showMoving(page, scene(-1));
  expect((await widthIn(page, await at(page, 60))) - drafted).toBeCloseTo(before, 2);
  expect((await widthIn(page, await at(page, 100))) - drafted).toBeLessThan(before - 0.1);
  expect((await widthIn(page, await at(page, 261))) - drafted).toBeCloseTo(-1, 1);
});

it('keeps the print where it is put while the shapes alone are on their way', async () => {
  const page = await openStill();
  const moved = {angle: 0, translation: [2, 0]} as const;
  await showMoving(page, scene(0.5, moved), 'shapes');
  const within = [1.5, 2] as const;
  const pixels = await at(page, 20);
  const [x, y] = await page.evaluate(
    (sheet) => Viewer.view.screenOf(sheet).map(Math.round),
    (scene(0).pieces[0]?.offset ?? []).map(
      (side, k) => side + (within[k] ?? 0),
    ) as unknown as Point,
  );
  expect(colourAt(pixels, x ?? NaN, y ?? NaN)).toEqual(printed(print, tile.pixels, moved, within));
});

it('is at its end at once where people want no motion', {tags: ['thorough']}, async () => {
  const page = await openStill();
  await page.emulateMedia({reducedMotion: 'reduce'});
  const drafted = await widthIn(page, await screenOf(page));
  await showMoving(page, scene(1));
  expect((await widthIn(page, await screenOf(page))) - drafted).toBeCloseTo(1, 1);
});

it('moves nothing where the pieces are not the same', {tags: ['thorough']}, async () => {
  const page = await openStill();
  const [left, right] = scene(1).pieces;
  if (!left || !right) throw new Error('There are two pieces.');
  const triangles = [
    [0, 1, 3],
    [1, 2, 3],
  ] as const;
  const other = {...scene(1), pieces: [{...left, triangles}, right]};
  const drafted = await widthIn(page, await screenOf(page));
  await showMoving(page, other);
  expect((await widthIn(page, await screenOf(page))) - drafted).toBeGreaterThan(0.8);
});

it('finds points and saves pictures as they are in the end', async () => {
  const page = await openStill();
  const picture = (): Promise<string> =>
    page.evaluate(async () => {
      const blob = await Viewer.view.toBlob(600);
      return String.fromCharCode(...new Uint8Array(await blob.arrayBuffer()));
    });
  await showMoving(page, scene(1));
  await at(page, 30);
  const found = await page.evaluate(
    ([dx, dy]) => {
      const [x, y] = Viewer.view.screenOf([dx - 0.9, dy + 2]);
      return Viewer.view.pieceAt(x, y)?.piece;
    },
    scene(0).pieces[0]?.offset ?? [NaN, NaN],
  );
  expect(found).toBe(0);
  const early = await picture();
  await at(page, 400);
  expect(await picture()).toBe(early);
});
