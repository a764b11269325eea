import {readFile} from 'node:fs/promises';

import type {Page} from 'playwright-core';
import {solve} from 'seamwise/node';
import {describe, expect, it} from 'vitest';

import {decoded} from '@samples/prints/raster.js';
import type {Alignment, Point} from '@/model/geometry/vectors.js';
import type {Print} from '@/model/print/repeating-print.js';
import type {ResultPiece} from '@/model/result/result.js';
import {sceneOf, type PatternScene} from '@/scene/scene.js';
import {
  checkered,
  colourAt,
  compared,
  eventually,
  realign,
  screenOf,
  setTile,
  settled,
  show,
  useViewer,
} from '../../support/page/viewer-page.js';

const openPage = useViewer();
const home: Alignment = {angle: 0, translation: [0, 0]};

/** A piece of 10 by 8 cm with a cut-out of 2 by 2 cm in its middle. */
function frame(name: string, alignment: Alignment): ResultPiece {
  const points: Point[] = [
    [0, 0],
    [10, 0],
    [10, 8],
    [0, 8],
    [4, 3],
    [4, 5],
    [6, 5],
    [6, 3],
  ];
  return {
    ...{name, alignment, rest: points, shape: points, mirroredFromInput: false},
    triangles: [
      [0, 1, 7],
      [0, 7, 4],
      [1, 2, 6],
      [1, 6, 7],
      [2, 3, 5],
      [2, 5, 6],
      [3, 0, 4],
      [3, 4, 5],
    ],
    outline: [0, 1, 2, 3],
    holes: [[4, 5, 6, 7]],
  };
}

const turned: readonly Alignment[] = [
  {angle: 0.3, translation: [2, -1]},
  {angle: -2.1, translation: [-131.7, 58.2]},
];

function twoFrames(print: Print, alignments = turned): PatternScene {
  const pieces = alignments.map((alignment, k) => frame(`frame ${k}`, alignment));
  return sceneOf({print, pieces, seams: [], symmetries: []}, print);
}

const oblique: Print = {group: 'p2', w1: [8, 0], w2: [2.6, 9.5]};
const centred: Print = {group: 'cmm', w1: [4.5, 6], w2: [-4.5, 6], cell: 'rectangular'};

async function expectPrinted(
  page: Page,
  scene: PatternScene,
  tile: Parameters<typeof compared>[2],
  least: number,
): Promise<void> {
  for (const {name, points, wrong} of await compared(page, scene, tile)) {
    expect({name, wrong}).toEqual({name, wrong: []});
    expect(points, name).toBeGreaterThanOrEqual(least);
  }
}

describe('a pixel of the screen is the pixel of the tile', () => {
  const tile = checkered();

  it.each([
    ['the cell of its lattice', oblique, 1],
    ['the rectangular cell of a rhombic lattice', centred, 1],
    ['the cell of its lattice, on a finer screen', oblique, 2],
  ])('that the alignment says, when the tile shows %s', async (_, print, ratio) => {
    const page = await openPage({ratio});
    const scene = twoFrames(print);
    await show(page, scene);
    await setTile(page, tile.png);
    await expectPrinted(page, scene, tile.pixels, 200);
  });

  it('after the pieces have been aligned anew', {tags: ['thorough']}, async () => {
    const page = await openPage();
    const scene = twoFrames(oblique);
    await show(page, scene);
    await setTile(page, tile.png);
    const next: Alignment[] = [
      {angle: 1.2, translation: [3, 3]},
      {angle: -2.1, translation: [-131.7, 60.2]},
    ];
    await realign(page, next);
    await expectPrinted(page, twoFrames(oblique, next), tile.pixels, 200);
    const stale = await compared(page, scene, tile.pixels);
    for (const {points, wrong} of stale) expect(wrong.length).toBeGreaterThan(points / 2);
  });

  it('after panning and zooming', {tags: ['thorough']}, async () => {
    const page = await openPage();
    const scene = twoFrames(oblique);
    await show(page, scene);
    await setTile(page, tile.png);
    await page.evaluate(() => {
      Viewer.view.zoomBy(1.7, [200, 250]);
      Viewer.view.panBy(-37, 21);
    });
    await settled(page);
    await expectPrinted(page, scene, tile.pixels, 50);
  });

  it('after the graphics context was lost and came back', {tags: ['thorough']}, async () => {
    const page = await openPage();
    const scene = twoFrames(oblique);
    await show(page, scene);
    await setTile(page, tile.png);
    await page.evaluate(async () => {
      const canvas = document.querySelector('canvas');
      const context = canvas?.getContext('webgl2')?.getExtension('WEBGL_lose_context');
      if (!canvas || !context) throw new Error('The context cannot be lost.');
      const once = (type: string): Promise<unknown> =>
        new Promise((resolve) => {
          canvas.addEventListener(type, resolve, {once: true});
        });
      const lost = once('webglcontextlost');
      context.loseContext();
      await lost;
      Viewer.view.panBy(10, 0); // moving meanwhile does no harm
      for (let k = 0; k < 3; k++) await new Promise(requestAnimationFrame);
      const restored = once('webglcontextrestored');
      context.restoreContext();
      await restored;
    });
    await settled(page);
    await expectPrinted(page, scene, tile.pixels, 200);
  });

  it('on every piece of a garment that was solved', async () => {
    const read = (file: string): Promise<string> =>
      readFile(new URL(`../../../public/${file}`, import.meta.url), 'utf8');
    const [garment, text, svg] = await Promise.all(
      ['garments/tee-m.json', 'prints/p4m.json', 'prints/p4m.svg'].map(read),
    );
    const print = JSON.parse(text ?? '') as Print;
    const result = await solve({garment: garment ?? '', print});
    const scene = sceneOf(result, print);
    const png = new URL('../../../public/prints/p4m.png', import.meta.url);
    const page = await openPage({width: 2000, height: 1400});
    await show(page, {...scene, symmetries: []}); // letters and axes would hide the print
    await page.evaluate(async (image) => {
      Viewer.view.setSeams(false); // numbers, too
      Viewer.view.setTile(await Viewer.svgTile(image));
    }, svg ?? '');
    await settled(page);
    await expectPrinted(page, scene, await decoded(await readFile(png)), 20);
  });
});

it('shows the page in cut-outs and beside the pieces', {tags: ['thorough']}, async () => {
  const page = await openPage();
  const scene = twoFrames(oblique);
  await show(page, scene);
  await setTile(page, checkered().png);
  const pixels = await screenOf(page);
  const [x, y] = scene.pieces[0]?.offset ?? [NaN, NaN];
  const [inHole, corner] = await page.evaluate(
    (middle) => [Viewer.view.screenOf(middle), [3, 3]] as const,
    [x + 5, y + 4] as const,
  );
  for (const [px, py] of [inHole, corner]) {
    expect(colourAt(pixels, Math.floor(px), Math.floor(py))).toEqual([251, 250, 248]);
  }
});

it('shows a print upright and not mirrored on a piece that lies as the cloth does', async () => {
  // red at the top, blue on the left
  const svg = `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 4 4"><path fill="#ddd" d="M0 0h4v4h-4z"/><path fill="#d01020" d="M0 0h4v1h-4z"/><path fill="#1030c0" d="M0 1h1v3h-1z"/></svg>`;
  const print: Print = {group: 'p1', w1: [10, 0], w2: [0, 8], oneWay: true};
  const page = await openPage();
  const scene = twoFrames(print, [home]);
  await show(page, scene);
  await page.evaluate(async (image) => {
    Viewer.view.setTile(await Viewer.svgTile(image));
  }, svg);
  await settled(page);
  const pixels = await screenOf(page);
  const [dx, dy] = scene.pieces[0]?.offset ?? [NaN, NaN];
  const at = async (p: Point): Promise<unknown> => {
    const [x, y] = await page.evaluate((q) => Viewer.view.screenOf(q), [
      p[0] + dx,
      p[1] + dy,
    ] as const);
    return colourAt(pixels, Math.floor(x), Math.floor(y));
  };
  expect(await at([8, 7])).toEqual([0xd0, 0x10, 0x20]);
  expect(await at([1.25, 2])).toEqual([0x10, 0x30, 0xc0]);
  expect(await at([8, 1])).toEqual([0xdd, 0xdd, 0xdd]);
});

it(
  'draws an SVG tile anew for a deep zoom, so that its edges stay sharp',
  {tags: ['thorough']},
  async () => {
    const svg = `<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 10 10"><path fill="#fff" d="M0 0h10v10h-10z"/><path d="M0 0h3v10h-3z"/></svg>`;
    const print: Print = {group: 'p1', w1: [10, 0], w2: [0, 8]};
    const page = await openPage();
    const scene = twoFrames(print, [home]);
    await show(page, scene);
    const [dx, dy] = scene.pieces[0]?.offset ?? [NaN, NaN];
    await page.evaluate(
      async ([image, edge]) => {
        Viewer.view.setTile(await Viewer.svgTile(image));
        for (let k = 0; k < 40; k++) Viewer.view.zoomBy(1.2, Viewer.view.screenOf(edge));
        // moves it to the middle of the screen
        const [x, y] = Viewer.view.screenOf(edge);
        Viewer.view.panBy(450 - x, 300 - y);
      },
      [svg, [3 + dx, 1.5 + dy]] as const,
    );
    const greys = async (): Promise<number> => {
      const pixels = await screenOf(page);
      const row = Array.from({length: 300}, (_, k) => colourAt(pixels, 300 + k, 300)[0]);
      expect(row[0]).toBe(0);
      expect(row.at(-1)).toBe(255);
      return row.filter((value) => value > 0 && value < 255).length;
    };
    expect(await page.evaluate(() => Viewer.view.scale)).toBe(400);
    await eventually(greys).toBeLessThanOrEqual(3);
  },
);
