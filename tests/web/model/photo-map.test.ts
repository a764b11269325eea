import fc from 'fast-check';
import {expect, it} from 'vitest';

import type {Point} from '@/model/geometry/vectors.js';
import {latticeOf, pixelOf, rebased, vectorsAtMiddle} from '@/model/print/photo-map.js';
import type {PhotoMap} from '@/model/print/photo-reading.js';

const size = {width: 900, height: 600};
const between = (min: number, max: number) => fc.double({min, max, noNaN: true});

/** Maps tilted by up to about 20 degrees, through a lens with a distortion of up to 4 %. */
const maps: fc.Arbitrary<PhotoMap> = fc
  .tuple(between(0, 6.28), between(60, 200), between(-3e-2, 3e-2), between(-0.04, 0.04))
  .map(([turn, side, tilt, lens]) => {
    const [x, y] = [side * Math.cos(turn), side * Math.sin(turn)];
    return {homography: [x, y, 400, y, -1.2 * x, 310, tilt, -tilt / 2, 1], lens};
  });

const places: fc.Arbitrary<Point> = fc.tuple(between(0, size.width), between(0, size.height));

it('finds the lattice coordinates of every place of a picture', () => {
  fc.assert(
    fc.property(maps, places, (map, place) => {
      const [x, y] = pixelOf(map, size, latticeOf(map, size, place));
      expect(x).toBeCloseTo(place[0], 5);
      expect(y).toBeCloseTo(place[1], 5);
    }),
  );
});

it('shows the same places for other vectors and another origin', () => {
  fc.assert(
    fc.property(maps, (map) => {
      const other = rebased(
        map,
        [
          [1, 1],
          [0, 2],
        ],
        [0.25, 0.5],
      );
      const [x, y] = pixelOf(other, size, [0.5, -1]);
      const [x0, y0] = pixelOf(map, size, [0.75, -1]);
      expect(x).toBeCloseTo(x0, 8);
      expect(y).toBeCloseTo(y0, 8);
    }),
  );
});

it('gives vectors as they lie at the middle of the picture, whatever the tilt', () => {
  const map: PhotoMap = {homography: [100, 0, 450, 0, -80, 300, 0, 0, 1], lens: 0};
  const {w1Px, w2Px, originPx} = vectorsAtMiddle(map, size);
  expect(w1Px[0]).toBeCloseTo(100, 6);
  expect(w2Px[1]).toBeCloseTo(-80, 6);
  expect(originPx).toEqual([450, 300]);
  const tilted = vectorsAtMiddle(
    {...map, homography: [100, 0, 450, 0, -80, 300, 0.05, 0, 1]},
    size,
  );
  expect(tilted.w1Px[0]).toBeCloseTo(100 - 0.05 * 450, 4);
});
