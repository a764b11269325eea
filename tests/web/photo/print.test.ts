/** Prints read from photos: equal sizes in files and in the dialog, as readable numbers. */
import {groupNames} from '@/model/base/core-tables.js';
import {describe, expect, it} from 'vitest';

import {directionSign} from '@/texts/direction-sign.js';
import {areSame, measuresOf, stepOf} from '@/photo/photo-step.js';
import {namePlace} from '@/editor/photo/stage-marks.js';
import {printOfPhoto} from '@/image/photo-print.js';
import {norm, radians, rotated, type Point} from '@/model/geometry/vectors.js';
import {vectorsAtMiddle} from '@/model/print/photo-map.js';
import type {PhotoMap, PhotoReading} from '@/model/print/photo-reading.js';
import {type GroupName} from '@/model/print/repeating-print.js';
import {latticeVectors, repeatOf} from '@/model/print/repeat.js';

const size = {width: 900, height: 600};
const map: PhotoMap = {homography: [100, 10, 420, 8, -80, 310, 0, 0, 1], lens: 0};

/** A rotated lattice of the group, with the rounding errors of calculations; |w1| is 1. */
function read(group: GroupName, turnDeg: number, w1Cm?: number): PhotoReading {
  const vectors = latticeVectors(group, {width: 1.3, height: 0.9, angleDeg: 71.2345678});
  const [w1, w2] = vectors.map((vector) => {
    const [x, y] = rotated(vector, radians(turnDeg));
    return [x / norm(vectors[0]) + 6e-16, y / norm(vectors[0]) - 6e-16] as const;
  }) as unknown as readonly [Point, Point];
  const scaled = ([x, y]: Point): Point => [(w1Cm ?? 1) * x, (w1Cm ?? 1) * y];
  return {
    ...{...size, map, ...vectorsAtMiddle(map, size), group},
    ...{w1: w1Cm === undefined ? null : scaled(w1), w2: w1Cm === undefined ? null : scaled(w2)},
    shape: [w1, w2],
    groups: groupNames.map((name) => ({...{name, rho: 0, worst: 0, map}, verdict: 'has'})),
    ...{confidence: 'sure', latticeUncertainty: 0.001, oneWay: false, stripes: false},
    ...{copies: 30, explained: 0.95, others: [], differing: [], notes: []},
    seen: {aspect: 1, error: 0.03},
  };
}

const isRound = (value: number): boolean =>
  /^-?\d+(\.\d{1,7})?$/.test(String(value)) && !Object.is(value, -0);

describe.each(groupNames)('a print of group %s', (group) => {
  it.each([0, 3.21, 90, -120])('turned by %s is written as wide as the sheet says', (turnDeg) => {
    const print = printOfPhoto(read(group, turnDeg, 8));
    const written = repeatOf(print).size;
    const w1Measured = {repeats: 10, cm: 80};
    const sheet = measuresOf({...stepOf(read(group, turnDeg)), w1Measured}).size;
    expect(written.width).toBeCloseTo(sheet.width, 3);
    expect(written.height).toBeCloseTo(sheet.height, 3);
    expect(norm(print.w1)).toBeCloseTo(8, 3);
    expect([...print.w1, ...print.w2].every(isRound)).toBe(true);
  });

  it('has a lattice that is the group’s own to a millionth, and zeros that are exact', () => {
    const {w1, w2, unscaled} = printOfPhoto(read(group, 0));
    expect(unscaled).toBe(true);
    const {size: own, turnDeg} = repeatOf({group, w1, w2});
    const exact = latticeVectors(group, own, turnDeg);
    for (const [k, vector] of [w1, w2].entries()) {
      const [x, y] = exact[k as 0 | 1];
      expect(norm([vector[0] - x, vector[1] - y])).toBeLessThan(1e-6 * norm(w1));
    }
    if (!['cm', 'cmm'].includes(group)) expect(w1[1]).toBe(0);
  });
});

describe('the name of an arrow', () => {
  const picture = {width: 1000, height: 800};
  const unit = 11;
  const isSeen = ([x, y]: Point): boolean =>
    Math.min(x, y, picture.width - x, picture.height - y) >= 2 * unit - 1e-9;

  it('is read beyond its end', () => {
    const [x, y] = namePlace([300, 300], [400, 300], picture);
    expect(x).toBeCloseTo(433, 6);
    expect(y).toBeCloseTo(300, 6);
  });

  it.each([
    [
      [700, 400],
      [995, 400],
    ],
    [
      [500, 700],
      [520, 5],
    ],
    [
      [100, 700],
      [2, 798],
    ],
    [
      [500, 400],
      [1400, -300],
    ],
    [
      [990, 790],
      [1300, 1100],
    ],
  ] as readonly (readonly [Point, Point])[])('lies on the picture from %j to %j', (from, to) => {
    expect(isSeen(namePlace(from, to, picture))).toBe(true);
  });
});

it('is the same picture by its bytes, whatever it is called', async () => {
  const of = (...bytes: number[]) => new Blob([new Uint8Array(bytes)]);
  expect(await areSame(of(1, 2, 3), new File([of(1, 2, 3)], 'other.jpg'))).toBe(true);
  expect(await areSame(of(1, 2, 3), of(1, 2, 4))).toBe(false);
  expect(await areSame(of(1, 2, 3), of(1, 2))).toBe(false);
});

it('points as a vector does', () => {
  const signs = [0, 30, 90, 134, 180, -100, -46, 350].map((degrees) =>
    directionSign(rotated([2, 0], radians(degrees))),
  );
  expect(signs).toEqual(['→', '↗', '↑', '↖', '←', '↓', '↘', '→']);
});
