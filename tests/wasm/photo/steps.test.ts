/** Work on images runs in steps, between which it can be cancelled. */
import {readFile} from 'node:fs/promises';
import {printFromPixels} from 'seamwise/node';
import {beforeAll, expect, it} from 'vitest';

import type {PhotoProgress} from '@/model/print/photo-reading.js';
import {SharedModule} from '@/solver/module/shared-module.js';
import {photo} from '@/solver/module/load.js';
import type {ModulePictureWork, PhotoModule} from '@/solver/module/photo.mjs';
import {
  photoModuleRequest,
  photoObjectModuleRequest,
  photoTileModuleRequest,
} from '@/solver/answers/photo.js';
import {painted, paper, ink, rose, within} from '../../support/image/pictures.js';

const side = 1024;
/** One cell of a print without symmetries. */
const tile = painted(side, side, (x, y) =>
  within(x, y, 0.3 * side, 0.4 * side, 0.2 * side)
    ? ink
    : within(x, y, 0.75 * side, 0.6 * side, 0.1 * side)
      ? rose
      : paper,
);
const cell = 64;
const coin = [500, 500] as const;
/** Many of these cells, and a coin on top. */
const cloth = painted(side, side, (x, y) =>
  within(x, y, ...coin, 60)
    ? [150, 150, 150]
    : within(x % cell, y % cell, 20, 25, 12)
      ? ink
      : within(x % cell, y % cell, 45, 40, 8)
        ? rose
        : paper,
);
const map = {homography: [cell, 0, 0, 0, -cell, side, 0, 0, 1], lens: 0} as const;

let module: PhotoModule;
beforeAll(async () => {
  const wasmBinary = await readFile(
    new URL('../../../web/src/solver/module/photo.wasm', import.meta.url),
  );
  module = await new SharedModule(photo, () => wasmBinary).load();
});

/** Number of steps in each stage. */
function stepsOf(work: ModulePictureWork<unknown>): Record<string, number> {
  const steps: Record<string, number> = {};
  let fraction = 0;
  for (let more = true; more;) {
    const stage = work.stage();
    more = work.advance();
    steps[stage] = (steps[stage] ?? 0) + 1;
    expect(work.failure()).toBeNull();
    expect(work.fraction()).toBeGreaterThanOrEqual(fraction);
    fraction = work.fraction();
  }
  work.delete();
  return steps;
}

it('reads a seamless picture in steps', () => {
  const {repeat, symmetry, ...others} = stepsOf(
    module.photo(photoModuleRequest(tile, {isTile: true})),
  );
  expect(repeat).toBeGreaterThan(20);
  expect(symmetry).toBeGreaterThan(50);
  expect(others).toEqual({});
});

it('makes the cell of a seamless picture in steps', () => {
  const whole = {homography: [side, 0, 0, 0, -side, side, 0, 0, 1], lens: 0} as const;
  const shape = [
    [1, 0],
    [0, 1],
  ] as const;
  const request = photoTileModuleRequest(tile, {map: whole, shape, isTile: true});
  expect(stepsOf(module.photoTile(request)).tile).toBeGreaterThan(4);
});

it('looks for a coin in steps', () => {
  const shape = [
    [1, 0],
    [0, 1],
  ] as const;
  const request = photoObjectModuleRequest(cloth, {object: 'eur1', at: coin, map, shape});
  expect(stepsOf(module.photoObject(request)).object).toBeGreaterThan(50);
});

it('is cancelled between two steps', async () => {
  const stop = new AbortController();
  const told: PhotoProgress[] = [];
  const reading = printFromPixels(
    tile,
    {isTile: true},
    {
      signal: stop.signal,
      onProgress: (progress) => {
        told.push(progress);
        stop.abort();
      },
    },
  );
  await expect(reading).rejects.toThrow(/abort/i);
  expect(told).toHaveLength(1);
  expect(told[0]?.fraction).toBeLessThan(1);
});
