import {readFileSync} from 'node:fs';

import {describe, expect, it} from 'vitest';

import {designs} from '../../web/prints/prints.js';
import {copies, printFile, tile} from '../../web/prints/tile.js';
import {groupNames} from '../../web/src/model/print.js';
import {imageCell, latticeType, printElements} from '../../web/src/model/wallpaper.js';

it('has one print for each of the 17 groups', () => {
  expect(designs.map(({print}) => print.group)).toEqual(groupNames);
});

it('has a lattice that is truly oblique', () => {
  const slanted = designs.filter(
    ({print: {w1, w2}}) =>
      latticeType('p2') === 'oblique' && Math.abs(w1[0] * w2[0] + w1[1] * w2[1]) > 1,
  );
  expect(slanted.map(({print}) => print.group)).toContain('p2');
});

describe.each(designs)('the print in $print.group', (design) => {
  const {print} = design;
  const [a, b] = imageCell(print);
  const area = ([x, y]: readonly [number, number], [u, v]: readonly [number, number]): number =>
    x * v - y * u;

  it('has a right-handed lattice of the type its group needs', () => {
    const [l1, l2] = [Math.hypot(...print.w1), Math.hypot(...print.w2)];
    const cosine = (print.w1[0] * print.w2[0] + print.w1[1] * print.w2[1]) / (l1 * l2);
    expect(area(print.w1, print.w2)).toBeGreaterThan(0);
    const type = latticeType(print.group);
    if (type !== 'oblique' && type !== 'rectangular') expect(l1).toBeCloseTo(l2, 9);
    if (type === 'rectangular' || type === 'square') expect(cosine).toBeCloseTo(0, 9);
    if (type === 'hexagonal') expect(cosine).toBeCloseTo(0.5, 9);
  });

  it('repeats every 6 to 14 cm', () => {
    for (const side of [print.w1, print.w2]) {
      expect(Math.hypot(...side)).toBeGreaterThanOrEqual(6);
      expect(Math.hypot(...side)).toBeLessThanOrEqual(14);
    }
  });

  it('shows every motif once for every symmetry of the group', () => {
    const cells = area(a, b) / area(print.w1, print.w2);
    const [width, height] = [Math.hypot(...a), Math.hypot(...b)];
    for (const placed of design.motifs) {
      const feet = copies(placed, print).filter(
        ({shift: [x, y]}) => x >= 0 && x < width && y >= 0 && y < height,
      );
      expect(feet).toHaveLength(Math.round(cells) * printElements(print).length);
    }
  });

  it('has a tile that goes on seamlessly: what leaves on one side enters on the other', () => {
    const [width, height] = [Math.hypot(...a), Math.hypot(...b)];
    for (const placed of design.motifs) {
      const all = copies(placed, print);
      const near = ([x, y]: readonly [number, number]): boolean =>
        x > -0.5 && x < 0.5 && y > 0 && y < height;
      for (const copy of all.filter(({shift}) => near(shift))) {
        const twin = all.find(
          (other) =>
            Math.hypot(other.shift[0] - copy.shift[0] - width, other.shift[1] - copy.shift[1]) <
              1e-9 && Math.abs(other.xx - copy.xx) + Math.abs(other.yx - copy.yx) < 1e-9,
        );
        expect(twin).toBeDefined();
      }
    }
  });

  it('is shipped as it is drawn now', () => {
    const path = `public/prints/${print.group}`;
    expect(readFileSync(`${path}.json`, 'utf8')).toBe(printFile(design));
    expect(readFileSync(`${path}.svg`, 'utf8')).toBe(tile(design));
  });
});
