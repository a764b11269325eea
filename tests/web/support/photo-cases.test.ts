/** Assumptions of the tests with photos: prints have their stated properties and positions. */
import {describe, expect, it} from 'vitest';

import type {Point} from '@/model/geometry/vectors.js';
import {printElements} from '@/model/print/wallpaper.js';
import {bandKinds, bandPrint} from '../../support/photo/band-prints.js';
import {applied} from '../../support/photo/camera.js';
import {cellPixels, type CaseHead, type PrintTruth} from '../../support/photo/case.js';
import {Chance} from '../../support/photo/chance.js';
import {samplerOf} from '../../support/photo/fabric-picture.js';
import {conditionsOf, type Conditions} from '../../support/photo/conditions.js';
import type {Print} from '../../support/photo/drawn-print.js';
import {decoded, jpegOf, stored, withExif, type Orientation} from '../../support/photo/files.js';
import {clearlyBroken, floralPrint, leastBroken} from '../../support/photo/floral-prints.js';
import {allGroups, elementsOf, shapeOf} from '../../support/photo/group-elements.js';
import {toLinear} from '../../support/photo/inks.js';
import {sidesOf, tilePsnr} from '../../support/photo/judge-tile.js';
import {judge, latticePoint, seenRepeats, type PhotoAnswer} from '../../support/photo/judge.js';
import {photographOf} from '../../support/photo/photograph.js';
import {floralCase} from '../../support/photo/print-cases.js';
import {almostPrint} from '../../support/photo/special-prints.js';
import {SymmetryShares} from '../../support/photo/symmetry-shares.js';
import {tileCase} from '../../support/photo/tile-cases.js';

const wrapped = (x: number): number => x - Math.round(x);

/** Lattices of each shape with w1 = (1, 0), as in the tables of the sources. */
const lattices: Readonly<Record<ReturnType<typeof shapeOf>, Point>> = {
  oblique: [0.3, 1.1],
  rectangular: [0, 1.3],
  rhombic: [Math.cos(1.2), Math.sin(1.2)],
  square: [0, 1],
  hexagonal: [0.5, Math.sqrt(0.75)],
};

/** The greatest difference of a sample between the cell and its image under an element. */
function apart(
  {cell: {n, planes}}: Print,
  {m: [a, b, c, d], a: [x, y]}: ReturnType<typeof elementsOf>[0],
): number {
  let most = 0;
  for (let j = 0; j < n; j++) {
    for (let i = 0; i < n; i++) {
      const to = ((c * i + d * j + y * n) & (n - 1)) * n + ((a * i + b * j + x * n) & (n - 1));
      for (const plane of planes) {
        most = Math.max(most, Math.abs((plane[j * n + i] ?? 0) - (plane[to] ?? 0)));
      }
    }
  }
  return most;
}

describe('the list of general positions', () => {
  it.each(allGroups)('of %s is what the table of the sources has', (group) => {
    const w1: Point = [1, 0];
    const w2 = lattices[shapeOf(group)];
    const own = elementsOf(group);
    const others = printElements({group, w1, w2});
    expect(own).toHaveLength(others.length);
    for (const {m, a} of own) {
      // B m = A B, and the shifts are equal up to a repeat
      const found = others.some(({xx, xy, yx, yy, shift}) => {
        const off = [
          m[0] + m[2] * w2[0] - xx,
          m[2] * w2[1] - yx,
          m[1] + m[3] * w2[0] - xx * w2[0] - xy * w2[1],
          m[3] * w2[1] - yx * w2[0] - yy * w2[1],
        ];
        const v = shift[1] / w2[1];
        const same = [wrapped(shift[0] - v * w2[0] - a[0]), wrapped(v - a[1])];
        return [...off, ...same].every((x) => Math.abs(x) < 1e-9);
      });
      expect(found, `(${m.join()}), (${a.join()})`).toBe(true);
    }
  });
});

describe('a print drawn for a group', () => {
  it.each(allGroups)('%s has all of its symmetries to the sample, and no other', (group) => {
    const print = floralPrint(group, new Chance(11), 128 * 2);
    for (const element of elementsOf(group)) expect(apart(print, element)).toBe(0);
    expect(leastBroken(print)).toBeGreaterThan(0.9 * clearlyBroken);
    const shares = new SymmetryShares(print.cell, print.w1, print.w2);
    for (const {m, a} of elementsOf(group)) expect(shares.ofElement(m, a)).toBeCloseTo(0, 9);
  });

  it.each(bandKinds)('%s has all of its symmetries, and no other', (kind) => {
    const print = bandPrint(kind, new Chance(5), 256);
    for (const element of elementsOf(print.group)) expect(apart(print, element)).toBeLessThan(1e-6);
    expect(print.broken).toBeGreaterThan(clearlyBroken);
  });

  it.each([
    ['p4m', 'p4'],
    ['p6m', 'p31m'],
    ['pmm', 'p2'],
    ['cm', 'p1'],
  ] as const)('%s is not taken for a print of no more than %s', (group, smaller) => {
    const print = floralPrint(group, new Chance(3), 256);
    expect(leastBroken({...print, group: smaller})).toBeLessThan(1e-9);
  });

  it.each([0, 3, 6])('of pair %i almost has more symmetry than it has', (number) => {
    const print = almostPrint(number, new Chance(9), 256);
    for (const element of elementsOf(print.group)) expect(apart(print, element)).toBe(0);
    expect(print.broken).toBeGreaterThan(0.02);
    expect(print.broken).toBeLessThan(clearlyBroken);
  });

  it('is not taken for its double cell', () => {
    const {w1, w2, cell} = floralPrint('p1', new Chance(3), 256);
    const {n} = cell;
    const twice = cell.planes.map((plane) =>
      plane.map((_, k) => plane[k - (k % n) + ((2 * k) % n)] ?? 0),
    );
    const [r, g, b] = twice;
    if (!r || !g || !b) throw new RangeError('three planes');
    const double: Print = {group: 'p1', w1: [2 * w1[0], 0], w2, cell: {n, planes: [r, g, b]}};
    expect(leastBroken(double)).toBeLessThan(1e-9);
  });
});

/** Only the view: no light, noise, blur, creases. */
const bare = (conditions: Conditions): Conditions => ({
  ...conditions,
  creases: 0,
  lamps: {least: 0.999, vignette: 0, cast: [1, 1, 1]},
  weave: 0,
  defocus: 0,
  motion: 0,
  iso: 0,
  halo: 0,
  quality: 98,
});

describe('a photograph', () => {
  it.each(['normal', 'hard'] as const)(
    'of level %s shows the print where its truth says',
    async (level) => {
      const chance = new Chance(level === 'hard' ? 21 : 22);
      const print = floralPrint('p1', chance, 512);
      const size = [480, 360] as const;
      const {pixels, view} = await photographOf(
        print,
        bare({...conditionsOf(level, chance), repeats: 3}),
        size,
        chance,
      );
      const sampler = samplerOf(print.cell, 1 / 150);
      const seen = new Float32Array(3);
      const correlation = (mirrored: boolean): number => {
        const pairs: [number, number][] = [];
        for (let k = 0; k < 4000; k++) {
          const x = chance.whole(0, pixels.width - 1);
          const y = chance.whole(0, pixels.height - 1);
          const [u, v] = latticePoint(view, [x + 0.5, y + 0.5]);
          sampler(mirrored ? -u : u, v, seen);
          const green = pixels.data[4 * (y * pixels.width + x) + 1] ?? 0;
          pairs.push([seen[1] ?? 0, toLinear(green / 255)]);
        }
        const mean = (c: 0 | 1): number =>
          pairs.reduce((sum, pair) => sum + pair[c], 0) / pairs.length;
        const [a, b] = [mean(0), mean(1)];
        const about = (f: (p: readonly [number, number]) => number): number =>
          pairs.reduce((sum, pair) => sum + f(pair), 0);
        const product = about(([p, q]) => (p - a) * (q - b));
        return product / Math.sqrt(about(([p]) => (p - a) ** 2) * about(([, q]) => (q - b) ** 2));
      };
      expect(correlation(false)).toBeGreaterThan(0.97);
      expect(correlation(true)).toBeLessThan(0.7);
    },
  );

  it('is the same whenever it is taken', async () => {
    const asked = {name: 'p2', level: 'hard', seed: 4, size: [240, 180]} as const;
    const [first, second] = [await floralCase(asked, 'p2'), await floralCase(asked, 'p2')];
    expect(second.truth).toEqual(first.truth);
    expect(Buffer.from(second.pixels.data).equals(Buffer.from(first.pixels.data))).toBe(true);
  });

  it.each([1, 2, 3, 4, 5, 6, 7, 8] as const)(
    'with EXIF orientation %i is stored so that a reader of the tag shows it upright',
    async (orientation: Orientation) => {
      const data = new Uint8ClampedArray(4 * 48 * 32).fill(255);
      for (let k = 0; k < 48 * 32; k++) {
        data.set([5 * (k % 48), 7 * Math.floor(k / 48), 128], 4 * k);
      }
      const picture = {width: 48, height: 32, data};
      const shown = await decoded(
        withExif(await jpegOf(stored(picture, orientation), 98), orientation, 26),
      );
      expect([shown.width, shown.height]).toEqual([48, 32]);
      const most = data.reduce((m, x, k) => Math.max(m, Math.abs(x - (shown.data[k] ?? 0))), 0);
      expect(most).toBeLessThan(30);
    },
  );
});

describe('a seamless tile', () => {
  it.each([
    ['p1', 0],
    ['p4', 2],
    ['p31m', 1],
    ['cm', 2],
  ] as const)('of %s, choice %i, goes on over its edges', async (group, number) => {
    const {truth, pixels} = await tileCase('tile', group, number, 8);
    const {width, height} = pixels;
    const across = (x0: number, x1: number): number => {
      let sum = 0;
      for (let y = 0; y < height; y++) {
        for (let c = 0; c < 3; c++) {
          const at = (x: number): number => pixels.data[4 * (y * width + x) + c] ?? 0;
          sum += Math.abs(at(x0) - at(x1));
        }
      }
      return sum;
    };
    const inside = Math.max(
      ...[0.2, 0.4, 0.6, 0.8].map((s) => across(Math.round(s * width), Math.round(s * width) + 1)),
    );
    expect(across(width - 1, 0)).toBeLessThan(1.5 * inside + 3 * height);
    // its edges are whole repeats
    const [u0, v0] = latticePoint(truth, [0, height]);
    const [u1, v1] = latticePoint(truth, [width, height]);
    expect(Math.hypot(wrapped(u1 - u0), wrapped(v1 - v0))).toBeLessThan(1e-9);
  });
});

describe('the judge', async () => {
  const asked = {name: 'pmg', level: 'normal', seed: 2, size: [240, 180]} as const;
  const truth = (await floralCase(asked, 'pmg')).truth as CaseHead & PrintTruth;
  const {w1, w2} = truth;

  /** An exact answer in another basis and origin, in the print's lattice coordinates. */
  const answer = (
    [p, q, r, s]: readonly [number, number, number, number],
    [u, v]: Point,
    group: PhotoAnswer['group'],
  ): PhotoAnswer => {
    const h = truth.homography;
    const column = (k: 0 | 1 | 2, a: number, b: number, c: number): number =>
      (h[3 * k] ?? 0) * a + (h[3 * k + 1] ?? 0) * b + (h[3 * k + 2] ?? 0) * c;
    const homography = ([0, 1, 2] as const).flatMap((k) => [
      column(k, p, r, 0),
      column(k, q, s, 0),
      column(k, u, v, 1),
    ]);
    return {
      homography,
      originPx: applied(truth.homography, [u, v]),
      w1: [p * w1[0] + r * w2[0], p * w1[1] + r * w2[1]],
      w2: [q * w1[0] + s * w2[0], q * w1[1] + s * w2[1]],
      group,
      confidence: 'sure',
      stripes: false,
    };
  };
  const judged = (one: PhotoAnswer) => {
    const {print} = judge(truth, one);
    if (!print) throw new RangeError('nothing was judged');
    return print;
  };

  it('finds nothing wrong with the truth, on any of its origins and bases', () => {
    for (const basis of [
      [1, 0, 0, 1],
      [-1, 0, 0, -1],
    ] as const) {
      for (const origin of [
        [0, 0],
        [0.5, 0],
        [0, 0.5],
        [3, -1],
      ] as const) {
        const print = judged(answer(basis, origin, 'pmg'));
        expect(print).toMatchObject({primitive: true, exactGroup: true, falseClaim: false});
        expect(print.index).toBeCloseTo(1, 6);
        expect(print.latticeError).toBeLessThan(0.001 + Math.abs(truth.lens));
        expect(print.originError).toBeLessThan(0.02);
        expect(print.aspectError).toBeCloseTo(0, 9);
        expect(print.angleError).toBeCloseTo(0, 9);
      }
    }
  });

  it('tells a smaller group from a wrong one', () => {
    expect(judged(answer([1, 0, 0, 1], [0, 0], 'p2'))).toMatchObject({
      exactGroup: false,
      falseClaim: false,
    });
    expect(judged(answer([1, 1, 0, 1], [0, 0], 'p2'))).toMatchObject({
      primitive: true,
      falseClaim: false,
    });
    for (const group of ['pmm', 'pgg', 'cm', 'p4'] as const) {
      expect(judged(answer([1, 0, 0, 1], [0, 0], group)).falseClaim, group).toBe(true);
    }
    // mirrors and glides are exchanged with w1 and w2
    expect(judged(answer([0, -1, 1, 0], [0, 0], 'pmg')).falseClaim).toBe(true);
  });

  it('measures how far the origin is off', () => {
    const off = judged(answer([1, 0, 0, 1], [0.02, 0], 'pmg')).originError;
    const exact = judged(answer([1, 0, 0, 1], [0, 0], 'pmg')).originError;
    const expected = (0.02 * Math.hypot(...w1)) / Math.sqrt(w1[0] * w2[1] - w1[1] * w2[0]);
    expect(Math.abs(off - expected)).toBeLessThan(exact + 1e-6);
    // p1 may have any origin
    expect(judged(answer([1, 0, 0, 1], [0.3, 0.1], 'p1')).originError).toBeLessThan(1e-6);
  });

  it('refuses a cell that is too large, and one that is too small', () => {
    expect(judged(answer([2, 0, 0, 1], [0, 0], 'p2'))).toMatchObject({primitive: false});
    const half = judged(answer([0.5, 0, 0, 1] as const, [0, 0], 'p1'));
    expect(half).toMatchObject({primitive: false, falseClaim: true});
  });

  it('measures how near a tile is to the cell, whatever the light, on the cell it shows', () => {
    const cell = cellPixels(floralPrint('cm', new Chance(6), 128).cell);
    const n = cell.width;
    // the rectangular cell, twice as large, darker, with its origin at the middle of the cell's
    // first sample
    const data = new Uint8ClampedArray(4 * n * n).fill(255);
    for (let y = 0; y < n; y++) {
      for (let x = 0; x < n; x++) {
        const [a, b] = [x, n - 1 - y];
        const from = 4 * (((a + b) & (n - 1)) * n + ((a - b) & (n - 1)));
        for (let c = 0; c < 3; c++) data[4 * (y * n + x) + c] = 0.9 * (cell.data[from + c] ?? 0);
      }
    }
    const sides = sidesOf('rectangular', 'rhombic');
    const shown = {pixels: {width: n, height: n, data}, sides, basis: [1, 0, 0, 1]} as const;
    // the middle of pixel (x, y) shows (a - b, a + b) / n
    const exact = tilePsnr(cell, {...shown, origin: [0, -1 / n]});
    expect(exact).toBeGreaterThan(32);
    expect(tilePsnr(cell, {...shown, origin: [0.03, -1 / n]})).toBeLessThan(exact - 6);
    expect(tilePsnr(cell, {...shown, basis: [0, -1, 1, 0], origin: [0, -1 / n]})).toBeLessThan(20);
  });

  it('reads repeats as the lens shows them', () => {
    const middle: Point = [truth.width / 3, truth.height / 4];
    const step = 1e-4;
    const [a] = seenRepeats(truth, middle);
    const [u0, v0] = latticePoint(truth, middle);
    const [u1, v1] = latticePoint(truth, [middle[0] + step * a[0], middle[1] + step * a[1]]);
    expect((u1 - u0) / step).toBeCloseTo(1, 3);
    expect((v1 - v0) / step).toBeCloseTo(0, 3);
  });
});
