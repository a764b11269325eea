/** Checks whether images opened as prints continue at their edges, by the core's measure. */
import {readdirSync, readFileSync} from 'node:fs';
import {createCanvas, loadImage} from '@napi-rs/canvas';
import {printFromPixels} from 'seamwise/node';
import {describe, expect, it} from 'vitest';

import type {OpenEdge, PhotoPixels, Side, TileSeams} from '@/model/print/photo-reading.js';
import {isThorough, sampleOf} from '../../support/level.js';
import {
  cut,
  halfDrop,
  leaf,
  painted,
  paper,
  ink,
  type Painting,
} from '../../support/image/pictures.js';

async function seamsOf(pixels: PhotoPixels): Promise<TileSeams> {
  const {reading} = await printFromPixels(pixels, {isTile: true, anyEdges: true});
  if (!reading.seams) throw new Error('nobody has looked at its edges');
  return reading.seams;
}

const openEdges = async (pixels: PhotoPixels): Promise<readonly OpenEdge[]> =>
  (await seamsOf(pixels)).straight;

const sidesOf = (edges: readonly {readonly side: Side}[]): readonly Side[] => [
  ...new Set(edges.map(({side}) => side)),
];
const folder = new URL('../../../public/prints/', import.meta.url);
const prints = readdirSync(folder).filter((file) => /^[a-z0-9]+\.png$/.test(file));

/** A part of a print from any point, in cells, at the resolution of the comparison. */
async function partOf(file: string, [x, y]: [number, number], [across, up]: [number, number]) {
  const image = await loadImage(readFileSync(new URL(file, folder)));
  const scale = 240 / Math.max(image.width, image.height);
  const [width, height] = [image.width, image.height].map((side) => Math.round(side * scale));
  if (!width || !height) throw new Error(`${file} is empty`);
  const canvas = createCanvas(Math.round(width * across), Math.round(height * up));
  const context = canvas.getContext('2d');
  for (const i of [0, 1]) {
    for (const j of [0, 1]) {
      const at = [Math.round((i - x) * width), Math.round((j - y) * height)] as const;
      context.drawImage(image, ...at, width, height);
    }
  }
  return context.getImageData(0, 0, canvas.width, canvas.height);
}

/** A commit checks each third print. */
const whole = isThorough ? prints : prints.filter((_, k) => k % 3 === 0);

describe.each(whole)('the cell of %s', (file) => {
  it('meets itself wherever it begins', async () => {
    expect(await openEdges(await partOf(file, [0.37, 0.21], [1, 1]))).toEqual([]);
  });
});

it.each(sampleOf(1, ['bouquet', 'p3', 'ditsy', 'cm', 'p1', 'p2', 'p6']))(
  'sees that a part of %s does not meet itself',
  async (name) => {
    const part = await partOf(`${name}.png`, [0.37, 0.21], [0.63, 1]);
    expect(sidesOf(await openEdges(part))).toEqual(['left', 'right']);
  },
);

it('marks the part of an edge at which a disc is cut', async () => {
  const edges = await openEdges(painted(220, 200, cut));
  expect(sidesOf(edges)).toEqual(['left', 'right', 'top', 'bottom']);
  const [left] = edges;
  // it is 90 px high about a point 60 px below the corner
  expect(left?.from).toBeCloseTo(15 / 200, 1);
  expect(left?.to).toBeCloseTo(105 / 200, 1);
});

it('sees a change of light from one edge to the other', async () => {
  const shaded: Painting = (x) => [100 + x / 2, 100 + x / 2, 90];
  expect(sidesOf(await openEdges(painted(200, 120, shaded)))).toEqual(['left', 'right']);
});

it.each<[string, Painting]>([
  ['a check', (x, y) => (x < 100 === y < 100 ? ink : paper)],
  ['stripes', (x) => (x < 70 ? ink : paper)],
  ['a leaf on a plain ground', leaf],
  ['nothing at all', () => paper],
])('lets %s begin and end at an edge', async (_, painting) => {
  expect(await openEdges(painted(200, 200, painting))).toEqual([]);
});

it('knows a half-drop by its neighbours half a side further on', async () => {
  const {straight, halfDrop: dropped, brick} = await seamsOf(painted(220, 200, halfDrop));
  expect(sidesOf(straight)).toEqual(['left', 'right']);
  expect(dropped).toEqual([]);
  expect(brick).not.toEqual([]);
});
