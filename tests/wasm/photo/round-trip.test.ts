/** A print that is photographed, read and scaled fits a garment as well as the print itself. */
import {readFileSync} from 'node:fs';

import {printFromPixels, solve} from 'seamwise/node';
import {expect, it} from 'vitest';

import {decoded} from '@samples/prints/raster.js';
import {angleOf, combined, norm, rotated, type Point} from '@/model/geometry/vectors.js';
import {latticeOf, pixelOf} from '@/model/print/photo-map.js';
import type {PhotoReading} from '@/model/print/photo-reading.js';
import type {Print} from '@/model/print/repeating-print.js';
import {sampleOf} from '../../support/level.js';
import type {LatticeView} from '../../support/photo/camera.js';
import {Chance} from '../../support/photo/chance.js';
import {conditionsOf, type PhotoLevel} from '../../support/photo/conditions.js';
import {photographOf} from '../../support/photo/photograph.js';
import {sampledPrint} from '../../support/photo/sample-cell.js';
import {sample} from '../../support/garments/samples.js';

const file = (name: string): Buffer =>
  readFileSync(new URL(`../../../public/prints/${name}`, import.meta.url));

const tee = sample('tee');

/** Vectors of the print itself that correspond to the reading's w1 and w2. [cm] */
function seenVectors({w1, w2}: Pick<Print, 'w1' | 'w2'>, view: LatticeView, reading: PhotoReading) {
  const {homography, lens} = view;
  const vector = (i: number, j: number): Point => {
    const middle = latticeOf(reading.map, reading, [reading.width / 2, reading.height / 2]);
    const at = (u: number, v: number): Point =>
      latticeOf(
        {homography: [...homography], lens},
        reading,
        pixelOf(reading.map, reading, [Math.round(middle[0]) + u, Math.round(middle[1]) + v]),
      );
    const [from, to] = [at(0, 0), at(i, j)];
    return combined([w1, w2], Math.round(to[0] - from[0]), Math.round(to[1] - from[1]));
  };
  return [vector(1, 0), vector(0, 1)] as const;
}

/**
 * Reads a photo of the print, with both vectors measured by tape and the warp of the original
 * print.
 */
async function readAgain(print: Print, name: string, level: PhotoLevel): Promise<Print> {
  const {group, oneWay = false} = print;
  const chance = new Chance(name.length + 7);
  const cloth = sampledPrint(print, await decoded(file(`${name}.png`)), 256);
  const conditions = conditionsOf(level, chance.branch());
  const {pixels, view} = await photographOf(cloth, conditions, [720, 540], chance.branch());
  const camera = level === 'scan' ? {} : {f35: conditions.f35};
  const {reading} = await printFromPixels(pixels, camera);
  expect(reading.group).toBe(group);
  const [first, second] = seenVectors(print, view, reading);
  const measured = await printFromPixels(pixels, {
    ...camera,
    w1Measured: {repeats: 10, cm: 10 * norm(first)},
    w2Measured: {repeats: 10, cm: 10 * norm(second)},
  });
  const read = measured.print;
  const turn = angleOf(first) - angleOf(read.w1);
  return {
    ...{format: 'seamwise-print/1', group: read.group, oneWay},
    ...{w1: rotated(read.w1, turn), w2: rotated(read.w2, turn)},
  };
}

/** Mismatch of the tee, which is what even weights minimise, as a share of the random one. */
async function fitOn({group, w1, w2, oneWay = false}: Print): Promise<number> {
  const print = {format: 'seamwise-print/1', group, w1, w2, oneWay} as const;
  const {metrics} = await solve({garment: tee, print, options: {visibility: 'even'}});
  return metrics.fit / metrics.fitRandom;
}

const photographs: readonly (readonly [PhotoLevel, string])[] = [
  ['scan', 'pmm'],
  ['normal', 'cm'],
  ['scan', 'p1'],
  ['scan', 'p4m'],
  ['normal', 'p6'],
];

it.each(sampleOf(1, photographs))(
  'a tee on a print that was read off a picture, %s, fits as on %s itself',
  async (level, name) => {
    const print = JSON.parse(file(`${name}.json`).toString()) as Print;
    const [own, again] = [await fitOn(print), await fitOn(await readAgain(print, name, level))];
    expect(own).toBeLessThan(0.5);
    expect(Math.abs(again - own)).toBeLessThan(0.03);
  },
);
