import {expect, it} from 'vitest';

import {crossesInto, reachesInto} from '@/paper/boxes.js';
import type {Box} from '@/model/geometry/polyline.js';
import type {Point} from '@/model/geometry/vectors.js';

const box: Box = {low: [0, 0], high: [4, 2]};

const lines: readonly (readonly [string, boolean, Point, Point])[] = [
  ['within it', true, [1, 0.5], [3, 1.5]],
  ['through it', true, [-1, 1], [5, 1.5]],
  ['across a corner', true, [3.5, 2.2], [4.2, 1.5]],
  ['past a corner', false, [3.9, 2.4], [4.4, 1.9]],
  ['that ends to the left of it', false, [-3, 1], [-1, 1]],
  ['that begins to the right of it', false, [5, 1], [9, 1]],
  ['that ends below it', false, [1, -3], [1, -1]],
  ['that begins above it', false, [1, 3], [1, 9]],
];

it.each(lines)('a line %s: crosses into a box: %s', (_, isCrossing, from, to) => {
  expect(crossesInto([from, to], box)).toBe(isCrossing);
});

it('an outline around a box reaches into it, unless a hole is around it too', () => {
  const around = (by: number): readonly Point[] => [
    [-by, -by],
    [4 + by, -by],
    [4 + by, 2 + by],
    [-by, 2 + by],
  ];
  expect(crossesInto(around(2), box)).toBe(false);
  expect(reachesInto([around(2)], box)).toBe(true);
  expect(reachesInto([around(2), around(1)], box)).toBe(false);
});
