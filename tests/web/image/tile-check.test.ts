import {readdirSync, readFileSync} from 'node:fs';
import {createCanvas, loadImage} from '@napi-rs/canvas';
import {describe, expect, it} from 'vitest';

import {decoded} from '@samples/prints/raster.js';
import type {GroupName, Print} from '@/model/print/repeating-print.js';
import {repeatOf} from '@/model/print/repeat.js';
import {imageCell, latticeType} from '@/model/print/wallpaper.js';
import {checkTile, visibleDifference, wholeCell} from '@/image/tile-check.js';
import type {Pixels} from '@/image/tile-fabric.js';

const folder = new URL('../../../public/prints/', import.meta.url);
const prints = readdirSync(folder)
  .filter((file) => file.endsWith('.json'))
  .map((file): [string, Print] => [
    file.replace('.json', ''),
    JSON.parse(readFileSync(new URL(file, folder), 'utf8')) as Print,
  ]);

const png = (name: string): Buffer => readFileSync(new URL(`${name}.png`, folder));
const printNamed = (name: string): Print => {
  const found = prints.find(([id]) => id === name);
  if (!found) throw new Error(`there is no print ${name}`);
  return found[1];
};

/** A tile as saved by another program: resized and lossy. */
async function asJpeg(name: string, width: number, height: number): Promise<Pixels> {
  const canvas = createCanvas(width, height);
  canvas.getContext('2d').drawImage(await loadImage(png(name)), 0, 0, width, height);
  return decoded(canvas.toBuffer('image/jpeg', 70));
}

const check = (print: Print, pixels: Pixels, group: GroupName = print.group) =>
  checkTile(pixels, group, repeatOf(print).size, print.cell ?? 'primitive');

describe.each(prints)('the tile of %s', (name, print) => {
  it('has the symmetries of its group', async () => {
    const {worst, breaks, elements} = check(print, await decoded(png(name)));
    expect(worst).toBeLessThan(visibleDifference);
    expect(breaks).toEqual([]);
    for (const {rms} of elements) expect(rms).toBeLessThan(4);
  });

  it('keeps them as a photograph of 500 x 500 pixels', async () => {
    expect(check(print, await asJpeg(name, 500, 500)).worst).toBeLessThan(visibleDifference);
  });
});

describe('a tile with a blot', () => {
  /** A tile with a blot of 1/10 x 1/8 of the cell, its corner at (0.6, 0.25). */
  async function blotted(name: string): Promise<Pixels> {
    const image = await loadImage(png(name));
    const canvas = createCanvas(image.width, image.height);
    const context = canvas.getContext('2d');
    context.drawImage(image, 0, 0);
    context.fillStyle = '#0a50ff';
    context.fillRect(0.6 * image.width, 0.25 * image.height, image.width / 10, image.height / 8);
    return context.getImageData(0, 0, image.width, image.height);
  }

  it.each(['p4m', 'p6m', 'p4g', 'p31m'])(
    'is broken there, and most of all there, in %s',
    async (name) => {
      const {worst, breaks} = check(printNamed(name), await blotted(name));
      expect(worst).toBeGreaterThan(60);
      for (const {x, y, width, height, difference} of breaks.filter(
        (b) => b.difference > worst / 2,
      )) {
        expect(difference).toBeGreaterThan(visibleDifference);
        expect(x + width).toBeGreaterThan(0.59);
        expect(x).toBeLessThan(0.71);
        expect(y + height).toBeGreaterThan(0.24);
        expect(y).toBeLessThan(0.385);
      }
      const differences = breaks.map(({difference}) => difference);
      expect(differences).toEqual([...differences].sort((a, b) => b - a));
    },
  );

  it('is as good as any where nothing is asked of it', async () => {
    expect(check({...printNamed('p1'), w1: [10, 0], w2: [0, 12]}, await blotted('p1'))).toEqual({
      ...{worst: 0, elements: [], breaks: []},
    });
  });
});

it('tells which symmetries a tile lacks', async () => {
  const print = printNamed('p4');
  const {elements, worst} = check(print, await decoded(png('p4')), 'p4m');
  const lacking = elements.filter(({rms}) => rms > 8);
  expect(worst).toBeGreaterThan(visibleDifference);
  expect(lacking).toHaveLength(4);
  for (const {map} of lacking) expect(map.xx * map.yy - map.xy * map.yx).toBeCloseTo(-1, 9);
});

it.each(
  prints.filter(([, {group, cell}]) => !['p1', 'p2'].includes(group) || cell === 'primitive'),
)('is taken whole as the cell of %s', async (name, print) => {
  const [width = 0, height = 0] = imageCell(print).map((side) => Math.hypot(...side));
  const isCentred = ['rhombic', 'hexagonal'].includes(latticeType(print.group));
  const size = {width, height, angleDeg: 90};
  const found = wholeCell(await decoded(png(name)), print.group, size, isCentred ? 2 : 1);
  expect(found).toMatchObject({group: print.group, turnDeg: 0});
});

/** An image after a quarter turn counter-clockwise. */
function turnedBack({width, height, data}: Pixels): Pixels {
  const turned = new Uint8ClampedArray(data.length);
  for (let y = 0; y < height; y++)
    for (let x = 0; x < width; x++)
      for (let k = 0; k < 4; k++)
        turned[4 * ((width - 1 - x) * height + y) + k] = data[4 * (y * width + x) + k] ?? 0;
  return {width: height, height: width, data: turned};
}

it('is taken whole as the cell of a group after a quarter turn, if its axes are swapped', async () => {
  const print = printNamed('pmg');
  const {width, height} = repeatOf(print).size;
  const swapped = {width: height, height: width, angleDeg: 90};
  const turned = turnedBack(await decoded(png('pmg')));
  expect(wholeCell(turned, 'pmg', swapped, 1)).toMatchObject({
    ...{turnDeg: 90, size: {width, height}},
  });
});

it('is no cell of a group that it lacks, turned or not', async () => {
  const size = {width: 10, height: 12, angleDeg: 90};
  expect(wholeCell(await decoded(png('p1')), 'pmg', size, 1)).toBeUndefined();
});
