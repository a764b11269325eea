import {expect, it} from 'vitest';

import type {PhotoMap} from '@/model/print/photo-reading.js';
import {arrowNames} from '@/photo/arrow-names.js';

const size = {width: 400, height: 300};
const ways = {across: 'across', up: 'up'};

it('names the flatter arrow of a photo across, also on a photo taken from the side', () => {
  const upright: PhotoMap = {homography: [40, 5, 9, 3, -50, 7, 0, 0, 1], lens: 0};
  const onItsSide: PhotoMap = {homography: [5, 40, 9, -50, 3, 7, 0, 0, 1], lens: 0};
  expect(arrowNames(upright, size, ways)).toEqual({w1: 'across', w2: 'up'});
  expect(arrowNames(onItsSide, size, ways)).toEqual({w1: 'up', w2: 'across'});
});
