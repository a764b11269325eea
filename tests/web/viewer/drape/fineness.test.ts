/** Late frames reduce the resolution, and it recovers once there is time. */
import {expect, it} from 'vitest';

import {coarser, finest, MovingFineness} from '@/viewer/drape/fineness.js';

const after = (times: readonly number[], fineness = new MovingFineness()): MovingFineness => {
  for (const time of times) fineness.took(time);
  return fineness;
};
const frames = (count: number, time: number): readonly number[] =>
  Array.from({length: count}, () => time);

it('draws finely where a display shows 60 or 30 frames in a second', () => {
  expect(after(frames(500, 16.7)).now).toBe(finest);
  expect(after(frames(500, 33.4)).now).toBe(finest);
});

it('gives up multisampling first, then pixels, and no more of them than half of each side', () => {
  expect(after(frames(3, 70)).now).toEqual({samples: 0, ratio: 1});
  expect(after(frames(100, 70)).now).toEqual({samples: 0, ratio: 0.5});
});

it('is not coarser for one late frame, nor for a page that was asleep', () => {
  expect(after([...frames(5, 17), 60, ...frames(5, 17)]).now).toBe(finest);
  expect(after([...frames(5, 17), 5000, ...frames(5, 17)]).now).toBe(finest);
});

it('is as coarse as it gets after three frames of software rendering', () => {
  expect(after(frames(3, 300)).now).toEqual({samples: 0, ratio: 0.5});
  expect(after(frames(3, 5000)).now).toEqual({samples: 0, ratio: 0.5});
});

it('tries finer frames after a while in time, and waits longer after a trial in vain', () => {
  const fineness = after(frames(3, 70));
  const untilFiner = (): number => {
    for (let count = 1; ; count++) {
      fineness.took(17);
      if (fineness.now === finest) return count;
    }
  };
  const first = untilFiner();
  after(frames(3, 70), fineness);
  expect(fineness.now).not.toBe(finest);
  expect(untilFiner()).toBeGreaterThan(1.8 * first);
});

it('takes no more pixels than are there', () => {
  const raster = {width: 1200, height: 900, ratio: 2};
  expect(coarser(raster, finest)).toEqual(raster);
  expect(coarser(raster, {samples: 0, ratio: 1})).toEqual({width: 600, height: 450, ratio: 1});
  expect(coarser({...raster, ratio: 1}, {samples: 0, ratio: 1}).width).toBe(1200);
});
