import {describe, expect, it} from 'vitest';

import {collection} from '../../web/prints/collection.js';
import type {Design} from '../../web/prints/design.js';
import {
  clothOf,
  cosets,
  difference,
  leastDifference,
  imageFor,
  seenThrough,
  type Cloth,
} from '../../web/prints/measure.js';
import {printOf, tilesOf} from '../../web/prints/print-files.js';
import {rendered} from '../../web/prints/raster.js';
import {printDistance, printElements, type PlaneMap} from '../../web/src/model/wallpaper.js';

/** Differences are means over all pixels and the three colours, of 255. */
const still = 1;
const visible = 8;

/** At this density edges are 2 pixels soft, so that what is compared is the print and not the grid. [px/cm] */
const fine = 12;
/** Whoever looks for a symmetry everywhere looks less closely, at first. [px/cm] */
const coarse = 4;

const halfTurn: PlaneMap = {xx: -1, xy: 0, yx: 0, yy: -1, shift: [0, 0]};

async function clothsOf(design: Design, density: number, softened: number): Promise<Cloth[]> {
  const [width, height] = imageFor(design.cell, density);
  return Promise.all(
    tilesOf(design).map(async ({svg}) =>
      clothOf(design.cell, await rendered(svg, width, height), softened),
    ),
  );
}

/** The shift is further from all repeats than a quarter of the shortest one; along a stripe nothing ever changes. */
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

  it('lies on itself after every symmetry of its group, also across the borders of its tile', async () => {
    for (const cloth of await clothsOf(design, fine, 2)) {
      for (const element of printElements(cell)) {
        expect(difference(cloth, seenThrough(cloth, element))).toBeLessThan(still);
      }
    }
  });

  // A larger group has more linear parts on the same lattice or, with the same linear parts, a finer
  // lattice, or both in steps (Hermann 1929). Either is looked for at every place there is.
  it('has no other symmetry: every further turn or reflection that keeps its lattice shows, wherever it lies', async () => {
    for (const cloth of await clothsOf(design, coarse, 1)) {
      for (const map of cosets(cell)) {
        expect(leastDifference(cloth, seenThrough(cloth, map))).toBeGreaterThan(visible);
      }
    }
  });

  // The translations of a finer lattice cannot all lie within a third of the shortest repeat.
  it('has no finer lattice: every translation far from a repeat shows', async () => {
    const far = farFromRepeats(design);
    for (const cloth of await clothsOf(design, coarse, 1)) {
      expect(leastDifference(cloth, cloth, far)).toBeGreaterThan(visible);
    }
  });

  it('is marked as one-way just when cloth turned upside down looks different', async () => {
    for (const cloth of await clothsOf(design, coarse, 1)) {
      const turned = leastDifference(cloth, seenThrough(cloth, halfTurn));
      expect(printOf(design).oneWay).toBe(turned > visible);
      if (!printOf(design).oneWay) expect(turned).toBeLessThan(2);
    }
  });
});

it('would find the mirrors of p4m in a print that claims to be p4', async () => {
  const p4m = collection.find(({id}) => id === 'p4m');
  if (!p4m) throw new Error('there is no p4m');
  const [cloth] = await clothsOf(p4m, coarse, 1);
  if (!cloth) throw new Error('p4m has no colourway');
  const [mirror] = cosets({...p4m.cell, group: 'p4'});
  if (!mirror) throw new Error('p4 has no larger group');
  expect(leastDifference(cloth, seenThrough(cloth, mirror))).toBeLessThan(still);
});
