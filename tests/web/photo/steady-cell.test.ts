import {describe, expect, it} from 'vitest';

import {steadied} from '@/photo/steady-cell.js';
import type {Point} from '@/model/geometry/vectors.js';
import {pixelOf, rebased, vectorsAtMiddle} from '@/model/print/photo-map.js';
import type {PhotoMap, PhotoReading} from '@/model/print/photo-reading.js';
import type {GroupName} from '@/model/print/repeating-print.js';

const size = {width: 800, height: 600};
/** A square in perspective, w2 upwards. */
const square: PhotoMap = {homography: [90, 10, 380, 8, -85, 310, 0.01, -0.02, 1], lens: 0.01};

const reading = (map: PhotoMap, group: GroupName): PhotoReading => ({
  ...size,
  map,
  ...vectorsAtMiddle(map, size),
  ...{w1: null, w2: null, group},
  shape: [
    [1, 0],
    [0, 1],
  ],
  groups: (['p1', 'pmm', 'p4g'] as const).map((name) => ({
    ...{name, map, rho: 0, worst: 0},
    verdict: 'has',
  })),
  ...{confidence: 'sure', latticeUncertainty: 0.001, oneWay: false, stripes: false},
  ...{copies: 9, explained: 0.95, others: [], differing: [], notes: []},
  seen: {aspect: 1, error: 0.03},
});

/** Corners of a cell. */
const cornersOf = (map: PhotoMap): readonly Point[] =>
  (
    [
      [0, 0],
      [1, 0],
      [0, 1],
    ] as const
  ).map((node) => pixelOf(map, size, node));

function expectNear(found: readonly Point[], wanted: readonly Point[], px: number): void {
  found.forEach(([x, y], k) => {
    expect(Math.hypot(x - (wanted[k]?.[0] ?? NaN), y - (wanted[k]?.[1] ?? NaN))).toBeLessThan(px);
  });
}

const quarter = [
  [0, 1],
  [-1, 0],
] as const;

describe('a cell in hand', () => {
  it.each(['pmm', 'p4g', 'cmm'] as const)(
    'stays where it is although %s has as good ones elsewhere',
    (group) => {
      const held = rebased(square, quarter, [0.5, 0.5]);
      const {map, shape} = steadied(reading(square, group), held, undefined);
      expectNear(cornersOf(map), cornersOf(held), 1e-6);
      expect(shape[0].map((x) => x + 0)).toEqual([0, 1]);
      expect(shape[1].map((x) => x + 0)).toEqual([-1, 0]);
    },
  );

  it('is mended by the reading, no further than that says', () => {
    const held = rebased(square, quarter, [0.53, 0.49]);
    const {map} = steadied(reading(square, 'p4g'), held, undefined);
    expectNear(cornersOf(map), cornersOf(rebased(square, quarter, [0.5, 0.5])), 1e-6);
  });

  it('goes nowhere that the group has no origin', () => {
    const held = rebased(square, quarter, [0.5, 0.5]);
    const {map} = steadied(reading(square, 'p6m'), held, undefined);
    expect(cornersOf(map)).not.toEqual(cornersOf(held));
    const any = steadied(
      reading(square, 'p1'),
      rebased(
        square,
        [
          [1, 0],
          [0, 1],
        ],
        [0.2, 0.3],
      ),
      undefined,
    );
    expectNear(
      cornersOf(any.map),
      cornersOf(
        rebased(
          square,
          [
            [1, 0],
            [0, 1],
          ],
          [0.2, 0.3],
        ),
      ),
      1e-6,
    );
  });

  it('holds for another group that was chosen, too', () => {
    const held = rebased(square, quarter, [0.5, 0.5]);
    const {groups} = steadied(reading(square, 'pmm'), held, 'p4g');
    const chosen = groups.find(({name}) => name === 'p4g');
    expectNear(cornersOf(chosen?.map ?? square), cornersOf(held), 1e-6);
  });
});
