import {readdirSync, readFileSync, statSync} from 'node:fs';

import {describe, expect, it} from 'vitest';

import {collection} from '@samples/prints/collection.js';
import {palettes} from '@samples/prints/palette.js';
import {indexedPng} from '@samples/prints/png.js';
import {pixelsOf, printFile, printOf, tilesOf} from '@samples/prints/print-files.js';
import {decoded, rendered} from '@samples/prints/raster.js';
import {imageSize} from '@samples/prints/tile.js';
import {groupNames} from '@/model/base/core-tables.js';
import {latticeType} from '@/model/print/wallpaper.js';
import {isThorough} from '../../../support/level.js';

const folder = 'public/prints';
const isStripe = (id: string): boolean => ['ticking', 'regatta'].includes(id);

it('has one print for each of the 17 groups, and seven more', () => {
  const ids = collection.map(({id}) => id);
  for (const name of groupNames) {
    expect(collection.find(({id}) => id === name)?.cell.group).toBe(name);
  }
  expect(new Set(ids).size).toBe(24);
});

it('has botanical, geometric and tailored prints', () => {
  const families = collection.map(({family}) => family);
  for (const family of ['botanical', 'geometric', 'tailored'] as const) {
    expect(families.filter((one) => one === family).length).toBeGreaterThanOrEqual(6);
  }
});

it('has a lattice that is truly oblique', () => {
  const p2 = collection.find(({id}) => id === 'p2')?.cell;
  expect(p2 && Math.abs(p2.w1[0] * p2.w2[0] + p2.w1[1] * p2.w2[1])).toBeGreaterThan(1);
});

it('ships nothing but the files of the collection, in 1.6 MB', () => {
  const made = collection.flatMap((design) => [
    `${design.id}.json`,
    ...tilesOf(design).flatMap(({name}) => [`${name}.svg`, `${name}.png`]),
  ]);
  const shipped = readdirSync(folder);
  expect(shipped.toSorted()).toEqual(made.toSorted());
  const bytes = shipped.map((name) => statSync(`${folder}/${name}`).size);
  expect(bytes.reduce((sum, size) => sum + size, 0)).toBeLessThan(1.6e6);
});

describe.each(collection)('$id', (design) => {
  const isSampled = isThorough || collection.indexOf(design) % 3 === 0;
  const {cell} = design;
  const [l1, l2] = [Math.hypot(...cell.w1), Math.hypot(...cell.w2)];

  it('has a right-handed lattice of the type its group needs', () => {
    const {w1, w2} = cell;
    const cosine = (w1[0] * w2[0] + w1[1] * w2[1]) / (l1 * l2);
    expect(w1[0] * w2[1] - w1[1] * w2[0]).toBeGreaterThan(0);
    const type = latticeType(cell.group);
    if (type !== 'oblique' && type !== 'rectangular') expect(l1).toBeCloseTo(l2, 9);
    if (type === 'rectangular' || type === 'square') expect(cosine).toBeCloseTo(0, 9);
    if (type === 'hexagonal') expect(cosine).toBeCloseTo(0.5, 9);
  });

  it('repeats every 6 to 14 cm, but for the length of a stripe', () => {
    const repeats = isStripe(design.id) ? [l1] : [l1, l2];
    for (const repeat of repeats) {
      expect(repeat).toBeGreaterThanOrEqual(6);
      expect(repeat).toBeLessThanOrEqual(14);
    }
  });

  it.runIf(isSampled)('is shipped in three colourways as it is drawn now', async () => {
    expect(readFileSync(`${folder}/${design.id}.json`, 'utf8')).toBe(printFile(design));
    const tiles = tilesOf(design);
    expect(new Set(tiles.map(({name}) => name)).size).toBe(3);
    expect(printOf(design).image).toBe(printOf(design).colourways?.[0]?.image);
    for (const {name, palette, svg, pixels} of tiles) {
      expect(readFileSync(`${folder}/${name}.svg`, 'utf8')).toBe(svg);
      // compares pixels, since bytes depend on the compressor
      const png = await decoded(readFileSync(`${folder}/${name}.png`));
      const drawn = await rendered(svg, ...pixels);
      expect([png.width, png.height]).toEqual(pixels);
      const now = await decoded(indexedPng(drawn, Object.values(palettes[palette])));
      expect(meanDifference(png.data, now.data)).toBeLessThan(0.2);
      expect(meanDifference(png.data, drawn.data)).toBeLessThan(2);
    }
  });

  it('has a raster tile of whole pixels with the proportions of its cell', () => {
    const [width, height] = imageSize(cell);
    const [across, up] = pixelsOf(cell);
    expect(across / up / (width / height)).toBeCloseTo(1, 4);
  });
});

// An empty band would look like a stripe across the body.
it.each(['p1', 'bouquet', 'ditsy'])(
  'scatters %s without an empty band, 0.5 cm wide',
  async (id) => {
    const design = collection.find((one) => one.id === id);
    const tile = design && tilesOf(design)[0];
    if (!design || !tile) throw new Error(`there is no ${id}`);
    const [width, height] = imageSize(design.cell).map((cm) => Math.round(cm * 2));
    const ground = await rendered(tile.svg.replace(/<defs>.*(?=<\/svg>)/s, ''), 1, 1);
    const drawn = await rendered(tile.svg, 10 * (width ?? 0), 10 * (height ?? 0));
    const across = new Array<number>(height ?? 0).fill(0);
    const along = new Array<number>(width ?? 0).fill(0);
    for (let k = 0; k < drawn.data.length; k += 4) {
      if ([0, 1, 2].every((c) => drawn.data[k + c] === ground.data[c])) continue;
      const [x, y] = [(k / 4) % drawn.width, Math.floor(k / 4 / drawn.width)];
      across[Math.floor(y / 10)] = (across[Math.floor(y / 10)] ?? 0) + 1;
      along[Math.floor(x / 10)] = (along[Math.floor(x / 10)] ?? 0) + 1;
    }
    for (const bands of [across, along]) {
      const mean = bands.reduce((sum, share) => sum + share, 0) / bands.length;
      expect(Math.min(...bands) / mean).toBeGreaterThan(1 / 4);
    }
  },
);

/** Mean difference of red, green, blue and alpha, of 255; infinite for different sizes. */
function meanDifference(one: Uint8ClampedArray, other: Uint8ClampedArray): number {
  if (one.length !== other.length) return Infinity;
  let sum = 0;
  for (let k = 0; k < one.length; k++) sum += Math.abs((one[k] ?? 0) - (other[k] ?? 0));
  return (sum / one.length) * (4 / 3);
}
