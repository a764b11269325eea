import type {JSHandle, Page} from 'playwright-core';
import {expect, it} from 'vitest';

import type {Pixels} from '@samples/prints/raster.js';
import type {Alignment, Point} from '@/model/geometry/vectors.js';
import type {Print} from '@/model/print/repeating-print.js';
import {sceneOf, type PatternScene} from '@/scene/scene.js';
import type {SeamStrip} from '@/viewer/seam-strip.js';
import {plainPrint, squarePair} from '../../support/garments/two-squares.js';
import {
  checkered,
  colourAt,
  printed,
  screenOf,
  settled,
  useViewer,
  type Colour,
} from '../../support/page/viewer-page.js';

const openPage = useViewer();
const home: Alignment = {angle: 0, translation: [0, 0]};
const runsOn: Alignment = {angle: 0, translation: [-4, 0]};
/** The seam at (4, y) of the print on the left is at (4, -y) on the right. */
const mirrored: Alignment = {angle: Math.PI, translation: [4, 0]};

const size = {width: 600, height: 400};
/** Scale of a seam of 4 cm, which is the largest possible. [px per cm] */
const scale = 40;
/** Middle of the seam. [px] */
const centre: Point = [300, 200];

const sceneIn = (print: Print, second: Alignment): PatternScene =>
  sceneOf(squarePair({print}), print, {alignments: [home, second]});

async function opened(
  scene: PatternScene,
  svg?: string,
): Promise<{readonly page: Page; readonly strip: JSHandle<SeamStrip>}> {
  const page = await openPage();
  const strip = await page.evaluateHandle(
    ({width, height}) => Viewer.openStrip(width, height),
    size,
  );
  await strip.evaluate(
    async (view, [shown, image, png]) => {
      view.show({scene: shown, seam: 0});
      view.setTile(image ? await Viewer.svgTile(image) : await Viewer.loadTile(png));
    },
    [scene, svg, checkered().png] as const,
  );
  await settled(page);
  return {page, strip};
}

const at = (pixels: Pixels, along: number, up: number): Colour =>
  colourAt(pixels, Math.floor(centre[0] + along * scale), Math.floor(centre[1] - up * scale));

/**
 * Mean difference of colours at equal distances above and below a line along the seam, from 0 to
 * 255.
 */
function difference(pixels: Pixels, off: number, middle = 0): number {
  const places = Array.from({length: 77}, (_, k) => (k - 38) / 20);
  const sum = places.reduce((all, along) => {
    const [above, below] = [at(pixels, along, middle + off), at(pixels, along, middle - off)];
    return all + above.reduce((one, value, k) => one + Math.abs(value - (below[k] ?? NaN)) / 3, 0);
  }, 0);
  return sum / places.length;
}

it(
  'shows the print on both sides of a seam as each piece lies on it',
  {tags: ['thorough']},
  async () => {
    const tile = checkered();
    const second: Alignment = {angle: 0.3, translation: [1, 2]};
    const {page} = await opened(sceneIn(plainPrint, second));
    const pixels = await screenOf(page);
    // sewn from the bottom up with the left square above: along is up both squares, in is to the
    // left and to the right
    const sides = [
      {alignment: home, up: 1, place: (along: number, d: number): Point => [4 - d, 2 + along]},
      {alignment: second, up: -1, place: (along: number, d: number): Point => [d, 2 + along]},
    ];
    const eps = 0.05;
    for (const {alignment, up, place} of sides) {
      let compared = 0;
      for (let along = -1.8; along < 1.9; along += 0.3) {
        for (let d = 0.2; d < 3.9; d += 0.3) {
          const colour = (a: number, b: number): string =>
            printed(plainPrint, tile.pixels, alignment, place(along + a, d + b)).join();
          const around = [
            colour(eps, eps),
            colour(-eps, eps),
            colour(eps, -eps),
            colour(-eps, -eps),
          ];
          if (new Set([...around, colour(0, 0)]).size > 1) continue;
          expect(at(pixels, along, up * d).join()).toBe(colour(0, 0));
          compared++;
        }
      }
      expect(compared).toBeGreaterThan(50);
    }
  },
);

it('shows nothing beyond the ends of the pieces', {tags: ['thorough']}, async () => {
  const {page} = await opened(sceneIn(plainPrint, runsOn));
  const pixels = await screenOf(page);
  for (const [along, up] of [
    [0, 4.3],
    [0, -4.3],
    [2.3, 1],
    [-2.3, -1],
  ] as const) {
    expect(at(pixels, along, up)).toEqual([251, 250, 248]);
  }
});

/** Fields of different colours, the same in y and 10 - y. No edge of a field is near the seam. */
function mirroredFields(): string {
  const fields = Array.from({length: 80}, (_, k) => {
    const [column, row] = [k % 8, Math.floor(k / 8)];
    const alike = Math.min(row, 9 - row);
    const colour = `rgb(${30 * column} ${60 * alike} ${(97 * column + 41 * alike) % 256})`;
    return `<path fill="${colour}" d="M${column * 10} ${row * 8}h10v8h-10z"/>`;
  });
  return `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 80 80">${fields.join('')}</svg>`;
}

it(
  'lets the print meet at the line when it runs on and when it is mirrored, and only then',
  {tags: ['thorough']},
  async () => {
    const print: Print = {group: 'pm', w1: [10, 0], w2: [0, 10]};
    const shown = async (second: Alignment): Promise<readonly [string, Pixels]> => {
      const scene = sceneIn(print, second);
      const {page} = await opened(scene, mirroredFields());
      return [scene.seams[0]?.kind ?? '', await screenOf(page)];
    };
    const near = 0.06;
    const [kind, plain] = await shown(runsOn);
    expect(kind).toBe('continuous');
    expect(difference(plain, near)).toBeLessThan(3);
    expect(difference(plain, 2)).toBeGreaterThan(20);
    const [other, folded] = await shown(mirrored);
    expect(other).toBe('mirrored');
    expect(difference(folded, near)).toBeLessThan(3);
    expect(difference(folded, 2)).toBeLessThan(3);
    const [, broken] = await shown({angle: 0, translation: [-6.5, 2.3]});
    expect(difference(broken, near)).toBeGreaterThan(20);
  },
);

it('shows the seam in another scene left of a line', {tags: ['thorough']}, async () => {
  const scene = sceneIn(plainPrint, runsOn);
  const {page, strip} = await opened(scene);
  const after = await screenOf(page);
  await strip.evaluate(
    (view, before) => {
      view.setWipe({before, split: 0.5});
    },
    sceneIn(plainPrint, {angle: 0.3, translation: [1, 2]}),
  );
  await settled(page);
  const both = await screenOf(page);
  const changed = (from: number): number =>
    Array.from({length: 70}, (_, k) => from + k / 40).filter(
      (along) => at(after, along, -1.5).join() !== at(both, along, -1.5).join(),
    ).length;
  expect(changed(-1.9)).toBeGreaterThan(20);
  expect(changed(0.05)).toBe(0);
});

it('knows what lies under a point, and marks a place across the seam', async () => {
  const {page, strip} = await opened(sceneIn(plainPrint, runsOn));
  const found = await strip.evaluate((view) => {
    const near = view.pieceAt(340, 160);
    return {near, place: near && view.placeOf(near), scale: view.scale, span: view.span};
  });
  expect(found.scale).toBe(scale);
  expect(found.span).toEqual([220, 380]);
  expect(found.near?.side).toBe('a');
  expect(found.near?.share).toBeCloseTo(0.75, 9);
  expect(found.near?.offset).toBeCloseTo(1, 9);
  expect(found.place?.piece).toBe(0);
  expect(found.place?.point[0]).toBeCloseTo(3, 9);
  expect(found.place?.point[1]).toBeCloseTo(3, 9);
  expect(await strip.evaluate((view) => view.pieceAt(340, 20))).toBeUndefined();
  await strip.evaluate((view) => {
    view.setCursor(0.75);
  });
  await settled(page);
  const pixels = await screenOf(page);
  const row = Array.from({length: 5}, (_, k) => colourAt(pixels, 338 + k, 120).join());
  expect(row).toContain('36,98,214');
});

it('tells whether it still shows the seam before', async () => {
  const {strip} = await opened(sceneIn(plainPrint, runsOn));
  const isCurrent = (): Promise<boolean> => strip.evaluate((view) => view.isCurrent);
  await expect.poll(isCurrent).toBe(true);
  const atOnce = await strip.evaluate(
    (view, scene) => {
      view.show({scene, seam: 0});
      return view.isCurrent;
    },
    sceneIn(plainPrint, home),
  );
  expect(atOnce).toBe(false);
  await expect.poll(isCurrent).toBe(true);
});

it('fits a long seam into its box, and follows the box', {tags: ['thorough']}, async () => {
  const {strip} = await opened(sceneIn(plainPrint, runsOn));
  await strip.evaluate(() => {
    const box = document.querySelector<HTMLElement>('body > div');
    if (box) box.style.width = '84px';
  });
  const shown = () => strip.evaluate(({scale, span}) => ({scale, span}));
  await expect.poll(shown).toEqual({scale: 15, span: [12, 72]});
});
