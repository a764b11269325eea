import type {PlaneMap} from '@/model/geometry/plane-map.js';
import {describe, expect, it} from 'vitest';

import {collection as all} from '@samples/prints/collection.js';
import type {Design} from '@samples/prints/design.js';
import {
  cosets,
  difference,
  finerFabric,
  leastDifference,
  imageFor,
} from '@samples/prints/measure.js';
import {printOf, tilesOf} from '@samples/prints/print-files.js';
import {palettes} from '@samples/prints/palette.js';
import {rendered, type Pixels} from '@samples/prints/raster.js';
import {printDistance, printElements} from '@/model/print/wallpaper.js';
import {seenThrough, type TiledFabric} from '@/image/tile-fabric.js';
import {isThorough} from '../../../support/level.js';

/** A commit checks each third design, each of another group. */
const collection = isThorough ? all : all.filter((_, k) => k % 3 === 0);

/** Thresholds of mean differences over all pixels and the three colours, of 255. */
const still = 1;
const visible = 8;
/** Threshold for pixels on both sides of a border: a tip may end in the last one. */
const seam = 2;

/** At this density edges are 2 pixels soft, so that prints and not grids are compared. [px/cm] */
const fine = 12;
/** A search for symmetries everywhere starts at a lower density. [px/cm] */
const coarse = 4;

const halfTurn: PlaneMap = {xx: -1, xy: 0, yx: 0, yy: -1, shift: [0, 0]};

async function fabricsOf(
  design: Design,
  density: number,
  softened: number,
): Promise<TiledFabric[]> {
  const [width, height] = imageFor(design.cell, density);
  return Promise.all(
    tilesOf(design).map(async ({svg}) =>
      finerFabric(design.cell, await rendered(svg, width, height), softened),
    ),
  );
}

/**
 * Returns whether a shift is further from all repeats than a quarter of the shortest one. Along a
 * stripe the print is constant.
 */
function farFromRepeats({cell, id}: Design): (shift: readonly [number, number]) => boolean {
  const {w1, w2} = cell;
  if (id === 'ticking' || id === 'regatta') {
    return ([x]) => Math.abs(x / w1[0] - Math.round(x / w1[0])) >= 1 / 4;
  }
  const repeats = printDistance({...cell, group: 'p1'});
  const near = Math.min(Math.hypot(...w1), Math.hypot(...w2)) / 4;
  return (shift) => repeats([...shift], [0, 0]) >= near;
}

describe.each(
  collection.map((design) => [`${design.id}, in ${design.cell.group},`, design] as const),
)('%s', (_, design) => {
  const {cell} = design;
  let seenCoarsely: Promise<TiledFabric[]> | undefined;
  const coarseFabrics = () => (seenCoarsely ??= fabricsOf(design, coarse, 1));

  it('lies on itself after every symmetry of its group, also across the borders of its tile', async () => {
    for (const fabric of await fabricsOf(design, fine, 2)) {
      for (const element of printElements(cell)) {
        expect(difference(fabric, seenThrough(fabric, element))).toBeLessThan(still);
      }
    }
  });

  // A larger group has more linear parts on the same lattice or, with the same linear parts, a
  // finer lattice, or both in steps (Hermann 1929). The tests search for either at every possible
  // place.
  it('has no other symmetry: every further turn or reflection that keeps its lattice shows, wherever it lies', async () => {
    for (const fabric of await coarseFabrics()) {
      for (const map of cosets(cell)) {
        expect(leastDifference(fabric, seenThrough(fabric, map))).toBeGreaterThan(visible);
      }
    }
  });

  // The translations of a finer lattice cannot all be within a third of the shortest repeat.
  it('has no finer lattice: every translation far from a repeat shows', async () => {
    const far = farFromRepeats(design);
    for (const fabric of await coarseFabrics()) {
      expect(leastDifference(fabric, fabric, far)).toBeGreaterThan(visible);
    }
  });

  it('is marked as one-way just when fabric turned upside down looks different', async () => {
    for (const fabric of await coarseFabrics()) {
      const turned = leastDifference(fabric, seenThrough(fabric, halfTurn));
      expect(printOf(design).oneWay).toBe(turned > visible);
      if (!printOf(design).oneWay) expect(turned).toBeLessThan(2);
    }
  });
});

// Plaids and stripes end with their last band, which the first one follows.
describe.each(
  collection
    .filter(({draw}) => draw(palettes.linen).includes('</defs>'))
    .map((d) => [d.id, d] as const),
)('the tile of %s', (_, design) => {
  it('goes on where it ends: what crosses a border reaches in as far from the other side', async () => {
    const [width, height] = imageFor(design.cell, fine);
    for (const {svg, palette} of tilesOf(design)) {
      const {ground} = palettes[palette];
      const [left, below] = [withNeighbour(svg, -1, 0), withNeighbour(svg, 0, 1)];
      const across = await rendered(left, 2 * width, height, ground);
      const down = await rendered(below, width, 2 * height, ground);
      const column = (x: number) => pixelsOf(across, (k) => [x, k], height);
      const row = (y: number) => pixelsOf(down, (k) => [k, y], width);
      expect(meanDifference(column(width - 1), column(2 * width - 1))).toBeLessThan(seam);
      expect(meanDifference(row(height), row(0))).toBeLessThan(seam);
    }
  });
});

/** The tile with the area to its left or below it, into which its motifs extend. */
function withNeighbour(svg: string, left: -1 | 0, below: 0 | 1): string {
  return svg.replace(/viewBox="0 0 ([\d.]+) ([\d.]+)"/, (_, width: string, height: string) => {
    const [w, h] = [Number(width), Number(height)];
    return `viewBox="${left * w} 0 ${w * (1 - left)} ${h * (1 + below)}"`;
  });
}

const pixelsOf = (
  {width, data}: Pixels,
  at: (k: number) => [number, number],
  count: number,
): number[] =>
  Array.from({length: count}, (_, k) => at(k)).flatMap(([x, y]) => [
    ...data.subarray(4 * (y * width + x), 4 * (y * width + x) + 3),
  ]);

const meanDifference = (one: readonly number[], other: readonly number[]): number =>
  one.reduce((sum, value, k) => sum + Math.abs(value - (other[k] ?? NaN)), 0) / one.length;

it('would find the mirrors of p4m in a print that claims to be p4', async () => {
  const p4m = all.find(({id}) => id === 'p4m');
  if (!p4m) throw new Error('there is no p4m');
  const [fabric] = await fabricsOf(p4m, coarse, 1);
  if (!fabric) throw new Error('p4m has no colourway');
  const [mirror] = cosets({...p4m.cell, group: 'p4'});
  if (!mirror) throw new Error('p4 has no larger group');
  expect(leastDifference(fabric, seenThrough(fabric, mirror))).toBeLessThan(still);
});
