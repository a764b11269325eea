/** Images without a recognisable print, and images that only seem to show one. */

import {applied, inverse, type LatticeView} from './camera.js';
import type {PhotoCase} from './case.js';
import {Chance} from './chance.js';
import {pixelShare, samplerOf, type Sampler} from './fabric-picture.js';
import {conditionsOf, type Conditions} from './conditions.js';
import {floralPrint} from './floral-prints.js';
import {allGroups} from './group-elements.js';
import {photographed, type Photograph, type Sides} from './photograph.js';
import {
  bricks,
  cloudy,
  faces,
  gradient,
  plainLinen,
  scattered,
  sceneSide,
  textPage,
  turnedAtRandom,
  whiteNoise,
} from './scenes.js';

type Size = readonly [number, number];
type Taking = (conditions: Conditions, size: Size, chance: Chance) => Promise<Photograph>;

const scenes = {
  'white-noise': whiteNoise,
  'cloudy-noise': cloudy,
  bricks,
  text: textPage,
  linen: plainLinen,
  scattered,
  'turned-at-random': turnedAtRandom,
  gradient,
  faces,
} as const;

const sceneSides: Sides = {w1: [sceneSide, 0], w2: [0, sceneSide]};

/** Shows seven tenths of the scene, so that nothing is visible twice. */
const ofScene =
  (kind: keyof typeof scenes): Taking =>
  (conditions, size, chance) => {
    const cell = scenes[kind](chance.branch());
    return photographed(
      (view) => samplerOf(cell, pixelShare(view, ...size)),
      sceneSides,
      {...conditions, repeats: 0.7, cellsShown: 0},
      size,
      chance,
    );
  };

/** A large print: the image's longer side is at most `seen` times its shortest repeat. */
const ofLargePrint =
  (seen: number): Taking =>
  (conditions, size, chance) => {
    const print = floralPrint(chance.of(['p1', 'p2', 'pg', 'p4'] as const), chance.branch(), 1024);
    const {w1, w2} = print;
    const shortest = Math.min(
      Math.hypot(...w1),
      Math.hypot(...w2),
      Math.hypot(w1[0] - w2[0], w1[1] - w2[1]),
    );
    const repeats = (seen * shortest) / Math.sqrt(w1[0] * w2[1] - w1[1] * w2[0]);
    return photographed(
      (view) => samplerOf(print.cell, pixelShare(view, ...size)),
      print,
      {...conditions, repeats, cellsShown: 0},
      size,
      chance,
    );
  };

/** Two fabrics that meet in the image's middle. */
const ofTwoPrints: Taking = (conditions, size, chance) => {
  const prints = [0, 1].map(() => floralPrint(chance.of(allGroups), chance.branch(), 512));
  const unit = sceneSide;
  const both = (view: LatticeView): Sampler => {
    const [middle] = applied(inverse(view.homography), [size[0] / 2, size[1] / 2]);
    const sides = prints.map(({w1, w2, cell}) => {
      const area = w1[0] * w2[1] - w1[1] * w2[0];
      const pixel = (pixelShare(view, ...size) * unit) / Math.sqrt(area);
      const sampler = samplerOf(cell, pixel);
      return (x: number, y: number, out: Float32Array): void => {
        sampler((x * w2[1] - y * w2[0]) / area, (y * w1[0] - x * w1[1]) / area, out);
      };
    });
    const [left, right] = sides;
    return (u, v, out) => (u < middle ? left : right)?.(u * unit, v * unit, out);
  };
  return photographed(both, sceneSides, {...conditions, repeats: 0.8, cellsShown: 0}, size, chance);
};

const takings: readonly (readonly [string, number, Taking])[] = [
  ['white-noise', 3, ofScene('white-noise')],
  ['cloudy-noise', 4, ofScene('cloudy-noise')],
  ['bricks', 4, ofScene('bricks')],
  ['text', 4, ofScene('text')],
  ['linen', 4, ofScene('linen')],
  ['scattered', 5, ofScene('scattered')],
  ['turned-at-random', 3, ofScene('turned-at-random')],
  ['gradient', 2, ofScene('gradient')],
  ['faces', 2, ofScene('faces')],
  ['one-repeat', 3, ofLargePrint(1)],
  ['one-and-a-half', 3, ofLargePrint(1.5)],
  ['two-prints', 3, ofTwoPrints],
];

/** Forty cases, in the order of their kinds; each is created on demand. */
export function decoyCases(seed: number, size: Size): readonly (() => Promise<PhotoCase>)[] {
  return takings.flatMap(([kind, count, take], t) =>
    Array.from({length: count}, (_, k) => async (): Promise<PhotoCase> => {
      const own = seed + 100 * t + k;
      const chance = new Chance(own);
      const conditions = conditionsOf('normal', chance.branch());
      const {pixels} = await take({...conditions, crop: 1}, size, chance);
      return {
        truth: {
          name: `decoy-${kind}-${k + 1}`,
          level: 'decoy',
          kind,
          seed: own,
          width: pixels.width,
          height: pixels.height,
          f35: conditions.f35,
          group: null,
          homography: null,
        },
        pixels,
        cell: undefined,
      };
    }),
  );
}
