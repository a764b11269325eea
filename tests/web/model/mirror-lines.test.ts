/** Possible alignments of symmetric pieces, in all groups that carry them. */
import {apply, determinant} from '@/model/geometry/plane-map.js';
import fc from 'fast-check';
import {describe, expect, it} from 'vitest';

import {onPrint, rotated, type Alignment, type Point} from '@/model/geometry/vectors.js';
import {inverse, mirrorAlignment, mirrors, turnToGrain} from '@/model/print/mirror-images.js';
import {
  axisLine,
  footOnAxis,
  mirrorLines,
  nearestMirrored,
  nextMirrored,
} from '@/model/print/mirror-lines.js';
import {groupsThatCarry, latticeVectors} from '@/model/print/repeat.js';
import {printElements, reducedBasis, type Repeat} from '@/model/print/wallpaper.js';
import {mirrorImage} from '@/scene/marks.js';

const number = (least: number, most: number): fc.Arbitrary<number> =>
  fc.double({min: least, max: most, noNaN: true});
const point = fc.tuple(number(-60, 60), number(-60, 60));
const alignment = fc.record({angle: number(-3.1, 3.1), translation: point});
const repeatIn = (group: Repeat['group']): fc.Arbitrary<Repeat> =>
  fc
    .record({width: number(1, 30), height: number(1, 30), turn: number(-180, 180)})
    .map(({width, height, turn}) => {
      const [w1, w2] = latticeVectors(group, {width, height, angleDeg: 90}, turn);
      return {group, w1, w2};
    });

/** A reflection in the line through a point at an angle, as p' = R F p + t. */
function reflection([x, y]: Point, axis: number): Alignment {
  const angle = 2 * axis + Math.PI;
  const [ix, iy] = mirrorImage({angle, translation: [0, 0]}, [x, y]);
  return {angle, translation: [x - ix, y - iy]};
}
const ownMap = fc.tuple(point, number(-1.6, 1.6)).map(([at, axis]) => reflection(at, axis));

/**
 * Least error of W'(p') = g W(p) for the orientation-reversing symmetries g of the print, each
 * applied to all points. [cm]
 */
function missed(repeat: Repeat, map: Alignment, first: Alignment, second: Alignment): number {
  const probes: readonly Point[] = [
    [0, 0],
    [10, 0],
    [-7, 21],
  ];
  const [a, b] = reducedBasis(repeat.w1, repeat.w2);
  const d = a[0] * b[1] - a[1] * b[0];
  const misses = printElements(repeat)
    .filter((element) => determinant(element) < 0)
    .map((element) => {
      const off = probes.map((p): Point => {
        const [x, y] = onPrint(second, mirrorImage(map, p));
        const [gx, gy] = apply(element, onPrint(first, p));
        return [x - gx, y - gy];
      });
      const [x, y] = off[0] ?? [0, 0];
      const [i, j] = [(x * b[1] - y * b[0]) / d, (a[0] * y - a[1] * x) / d].map(Math.round);
      const shift: Point = [(i ?? 0) * a[0] + (j ?? 0) * b[0], (i ?? 0) * a[1] + (j ?? 0) * b[1]];
      return Math.max(...off.map((one) => Math.hypot(one[0] - shift[0], one[1] - shift[1])));
    });
  return Math.min(...misses);
}

const runs = {seed: 5, numRuns: 60};

describe.each(groupsThatCarry('piece'))('a symmetric piece on %s', (group) => {
  it('is snapped to where its reflection is a symmetry of the print, to 1e-9 cm', () => {
    fc.assert(
      fc.property(repeatIn(group), ownMap, alignment, point, (repeat, map, wanted, about) => {
        const at = nearestMirrored(repeat, map, wanted, about);
        expect(at && missed(repeat, map, at, at)).toBeLessThan(1e-9);
        expect(at && mirrors(repeat, map, at, at)).toBe(true);
      }),
      runs,
    );
  });

  it('stays where it is when it lies well, and slides along its axis', () => {
    fc.assert(
      fc.property(
        ...[repeatIn(group), ownMap, alignment, point, number(-40, 40)],
        (repeat, map, wanted, about, way) => {
          const at = nearestMirrored(repeat, map, wanted, about) ?? wanted;
          const [dx, dy] = rotated([way, 0], (map.angle - Math.PI) / 2);
          const along: Alignment = {
            ...at,
            translation: [at.translation[0] + dx, at.translation[1] + dy],
          };
          const next = nearestMirrored(repeat, map, along, about);
          expect(next?.angle).toBeCloseTo(at.angle, 9);
          expect(next?.translation[0]).toBeCloseTo(along.translation[0], 8);
          expect(next?.translation[1]).toBeCloseTo(along.translation[1], 8);
        },
      ),
      runs,
    );
  });

  it('clicks over to the neighbouring line, half of the way across or more', () => {
    fc.assert(
      fc.property(repeatIn(group), ownMap, alignment, (repeat, map, wanted) => {
        const at = nearestMirrored(repeat, map, wanted, [0, 0]) ?? wanted;
        const axis = (map.angle - Math.PI) / 2;
        const {spacing = NaN} = axisLine(repeat, map, at) ?? {};
        const moved = (share: number): Alignment | undefined => {
          const [dx, dy] = rotated([0, share * spacing], axis);
          const [x, y] = at.translation;
          const shifted: Alignment = {...at, translation: [x + dx, y + dy]};
          return nearestMirrored(repeat, map, shifted, [0, 0]);
        };
        const wayOf = (share: number): number => {
          const [x, y] = moved(share)?.translation ?? [NaN, NaN];
          return Math.hypot(x - at.translation[0], y - at.translation[1]) / spacing;
        };
        expect(wayOf(0.45)).toBeCloseTo(0, 6);
        expect(wayOf(0.55)).toBeCloseTo(1, 6);
      }),
      runs,
    );
  });

  it('turns on to the next angle that it may have, in either sense', () => {
    fc.assert(
      fc.property(repeatIn(group), ownMap, alignment, (repeat, map, wanted) => {
        const at = nearestMirrored(repeat, map, wanted, [0, 0]) ?? wanted;
        const next = nextMirrored(repeat, map, at, [0, 0], 1) ?? wanted;
        expect(missed(repeat, map, next, next)).toBeLessThan(1e-9);
        expect(Math.abs(Math.sin((next.angle - at.angle) / 2))).toBeGreaterThan(0.1);
        const back = nextMirrored(repeat, map, next, [0, 0], -1);
        expect(Math.sin(((back?.angle ?? NaN) - at.angle) / 2)).toBeCloseTo(0, 9);
      }),
      runs,
    );
  });
});

describe.each(groupsThatCarry('pair'))('a mirrored pair on %s', (group) => {
  it('has its second piece show the mirror image of the first, and the other way round', () => {
    fc.assert(
      fc.property(
        ...[repeatIn(group), alignment, alignment, alignment],
        (repeat, map, first, like) => {
          const second = mirrorAlignment(repeat, map, first, like) ?? like;
          expect(missed(repeat, map, first, second)).toBeLessThan(1e-9);
          expect(mirrors(repeat, map, first, second)).toBe(true);
          const back = mirrorAlignment(repeat, inverse(map), second, first) ?? like;
          expect(missed(repeat, map, back, second)).toBeLessThan(1e-9);
        },
      ),
      runs,
    );
  });

  it('does not mirror once one of them is moved by a millimetre', () => {
    fc.assert(
      fc.property(repeatIn(group), alignment, alignment, (repeat, map, first) => {
        const second = mirrorAlignment(repeat, map, first) ?? first;
        const [x, y] = second.translation;
        const away = {...second, translation: [x + 0.07, y + 0.07] as const};
        expect(mirrors(repeat, map, first, away)).toBe(false);
      }),
      runs,
    );
  });
});

const withTurn = (repeat: Repeat, turn: number): Repeat => ({
  ...repeat,
  w1: rotated(repeat.w1, turn),
  w2: rotated(repeat.w2, turn),
});

it.each(groupsThatCarry('piece'))(
  'turns a print of %s so that symmetry and grain go together',
  (group) => {
    const rule = {angles: [0.3, 0.3 + Math.PI], tolerance: 0};
    fc.assert(
      fc.property(repeatIn(group), ownMap, (repeat, map) => {
        const turn = turnToGrain(repeat, map, [rule, rule], true);
        const after = withTurn(repeat, turn);
        const at = nearestMirrored(after, map, {angle: 0, translation: [0, 0]}, [0, 0], rule);
        expect(at && missed(after, map, at, at)).toBeLessThan(1e-9);
        expect(turnToGrain(after, map, [rule, rule], true)).toBe(0);
      }),
      runs,
    );
  },
);

it.each(groupsThatCarry('pair'))(
  'turns a print of %s so that a pair and its grain go together',
  (group) => {
    const [one, other] = [0.3, -0.8].map((angle) => ({
      angles: [angle, angle + Math.PI],
      tolerance: 0,
    }));
    fc.assert(
      fc.property(repeatIn(group), ownMap, (repeat, map) => {
        const turn = turnToGrain(repeat, map, [one, other], false);
        expect(turnToGrain(withTurn(repeat, turn), map, [one, other], false)).toBe(0);
        expect(turnToGrain(repeat, map, [one, undefined], false)).toBe(0);
      }),
      runs,
    );
  },
);

it('knows glides from mirrors', () => {
  const lattice = {w1: [10, 0], w2: [0, 8]} as const;
  expect(mirrorLines({...lattice, group: 'pg'})).toEqual([]);
  expect(mirrorLines({...lattice, group: 'pgg'})).toEqual([]);
  expect(mirrorLines({...lattice, group: 'p2'})).toEqual([]);
  expect(mirrorLines({...lattice, group: 'pm'})).toMatchObject([{spacing: 4, motifs: 8}]);
  const [pmg] = mirrorLines({...lattice, group: 'pmg'});
  expect(Math.abs((pmg?.offset ?? 0) % 4)).toBeCloseTo(2, 12);
});

it('says whether an axis runs through motifs or between them', () => {
  const repeat = {group: 'pmm', w1: [10, 0], w2: [0, 8]} as const;
  const map = reflection([3, 0], Math.PI / 2);
  const lying = (x: number): Alignment => ({angle: 0, translation: [x, 1]});
  expect(footOnAxis(map, [7, 5])).toEqual([expect.closeTo(3, 9), expect.closeTo(5, 9)]);
  expect(axisLine(repeat, map, lying(3))).toMatchObject({spacing: 5, isOnMotif: true});
  expect(axisLine(repeat, map, lying(13))?.isOnMotif).toBe(true);
  expect(axisLine(repeat, map, lying(8))?.isOnMotif).toBe(false);
  expect(axisLine(repeat, map, {angle: 0.3, translation: [3, 1]})).toBeUndefined();
});

it('keeps to the angles of the grain, and says so when none is left', () => {
  const repeat = {group: 'pm', w1: [10, 0], w2: [0, 8]} as const; // mirror lines run across
  const map = reflection([0, 0], Math.PI / 2);
  const wanted = {angle: 1.5, translation: [1, 2]} as const;
  const free = nearestMirrored(repeat, map, wanted, [0, 0]);
  expect(free?.angle).toBeCloseTo(Math.PI / 2, 12);
  const upright = {angles: [0, Math.PI], tolerance: 0};
  expect(nearestMirrored(repeat, map, wanted, [0, 0], upright)).toBeUndefined();
});
