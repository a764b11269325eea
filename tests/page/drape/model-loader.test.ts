/** An exported model in the loader of three.js, as a third-party page opens it. */
import type {Browser} from 'playwright-core';
import {afterAll, beforeAll, expect, it} from 'vitest';

import {coordinates, onPrint, type Alignment, type Point} from '@/model/geometry/vectors.js';
import {cellPicture, glb} from '@/files/glb/glb.js';
import type {Print} from '@/model/print/repeating-print.js';
import {imageCell} from '@/model/print/wallpaper.js';
import {openBrowser, sourcesOf} from '../../support/page/browser.js';
import {everywhere, painted, pngOf} from '../../support/image/pictures.js';
import {at} from '../../support/plane.js';
import {readGlb} from '../../support/drape/read-glb.js';
import {squaresDrape, squaresResult} from '../../support/drape/sewn-squares.js';

let browser: Browser | undefined;

beforeAll(async () => {
  browser = await openBrowser();
});
afterAll(() => browser?.close());

const print: Print = {group: 'p1', w1: [5, 1], w2: [2, 6], cell: 'primitive'};
const alignments: readonly Alignment[] = [
  {angle: 0.3, translation: [31.7, -12.2]},
  {angle: -1.9, translation: [-7.1, 99.3]},
];
const result = {
  pieces: squaresResult.pieces.map((piece, k) => ({...piece, alignment: at(alignments, k)})),
};

it('is opened by the loader of three.js, which shows the print where the pieces lie on it', async () => {
  if (!browser) throw new Error('The browser is not open yet.');
  const {width, height, paint} = everywhere;
  const picture = cellPicture(new Uint8Array(pngOf(painted(width, height, paint))));
  if (!picture) throw new Error('a PNG is one');
  const bytes = glb(result, squaresDrape(), print, {picture, attributes: true, form: true});
  const read = readGlb(bytes);
  const [primitive] = read.json.meshes[0]?.primitives ?? [];
  const attribute = (name: string) => read.vectors(primitive?.attributes[name] ?? -1);
  const [positions = [], places = [], pieces = []] = ['POSITION', '_SHAPE', '_PIECE'].map(
    attribute,
  );
  const triangles = read.vectors(primitive?.indices ?? -1).flat();
  /** The middle of each triangle. */
  const middles = (list: readonly (readonly number[])[]): readonly (readonly number[])[] =>
    Array.from({length: triangles.length / 3}, (_, k) =>
      at(list, 0).map((__, axis) => {
        const corners = triangles.slice(3 * k, 3 * k + 3);
        return corners.reduce((sum, one) => sum + at(at(list, one), axis) / 3, 0);
      }),
    );
  const page = await browser.newPage();
  await page.goto(sourcesOf('loader'));
  await page.waitForFunction(() => 'openModel' in globalThis);
  const model = Buffer.from(bytes).toString('base64');
  const asked = middles(positions) as readonly (readonly [number, number, number])[];
  const opened = await page.evaluate(([file, where]) => globalThis.openModel(file, where), [
    model,
    asked,
  ] as const);
  expect(opened).toMatchObject({
    ...{names: ['garment', 'form'], triangles: triangles.length / 3},
    ...{repeats: true, isDoubleSided: true},
  });
  expect(opened.colours).toHaveLength(64);
  const shapes = middles(places);
  const cell = imageCell(print);
  for (const [k, colour] of opened.colours.entries()) {
    const {alignment} = at(result.pieces, at(at(pieces, at(triangles, 3 * k)), 0));
    const [u, v] = coordinates(cell, onPrint(alignment, at(shapes, k) as unknown as Point));
    const wanted = paint(u * width, (1 - v) * height);
    for (const [channel, value] of wanted.entries())
      expect(Math.abs(value - at(colour, channel))).toBeLessThanOrEqual(8);
  }
});
