/**
 * Times of tasks for each movement of a pointer, as quotients by the time of a fixed calculation.
 */
import {readFileSync} from 'node:fs';

import {readGarment} from 'seamwise/node';
import {expect, it} from 'vitest';

import {targetsAt} from '@/clicks/pick.js';
import {pickIndex} from '@/clicks/pick-index.js';
import {obstaclesTo, turnsOf, type Bolt, type LaidPiece} from '@/marker/places.js';
import {plus, rotated, towards, type Point} from '@/model/geometry/vectors.js';
import {sureSeams} from '@/pairing/suggest.js';
import {manyRounds, pressesOn} from '../support/clickable-sheet.js';

/** A million rotations of a point. */
function yardstick(): void {
  let point: Point = [1, 0];
  for (let k = 0; k < 1e6; k++) point = rotated(point, k);
  expect(Math.hypot(...point)).toBeCloseTo(1, 6);
}

/**
 * Processor time of a task over that of the yardstick; the least of each in several alternating
 * tries.
 */
function yardsticks(task: () => void, tries = 12): number {
  const least = [Infinity, Infinity];
  for (let k = 0; k < tries; k++) {
    [task, yardstick].forEach((one, which) => {
      const start = process.cpuUsage();
      one();
      least[which] = Math.min(least[which] ?? Infinity, process.cpuUsage(start).user);
    });
  }
  const [ours = NaN, unit = NaN] = least;
  return ours / unit;
}

it('of a thousand presses on a garment of forty pieces with 200 vertices', () => {
  const index = pickIndex(manyRounds(40));
  const presses = pressesOn(40, 1000);
  const press = () => {
    for (const point of presses) targetsAt(index, point, 1);
  };
  expect(yardsticks(press)).toBeLessThan(1);
});

it('of a press: it hardly grows with the number of pieces', () => {
  const [few, many] = [5, 40].map((pieces) => {
    const index = pickIndex(manyRounds(pieces));
    const presses = pressesOn(pieces, 1000);
    return yardsticks(() => {
      for (const point of presses) targetsAt(index, point, 1);
    });
  });
  expect((many ?? NaN) / (few ?? NaN)).toBeLessThan(2);
});

it('of sixty places for a piece among twelve with 200 vertices', () => {
  const outline = Array.from({length: 200}, (_, k): Point => {
    const angle = (2 * Math.PI * k) / 200;
    return rotated([15 * (1 + 0.2 * Math.cos(3 * angle)), 0], angle);
  });
  const fabric: Bolt = {
    repeat: {group: 'p2', w1: [10, 0], w2: [0, 10]},
    ...{origin: [3, 2], widthCm: 150, selvedgeCm: 1, gapCm: 0.2, flaws: [], isOneWay: false},
  };
  const laid = Array.from({length: 12}, (_, k): LaidPiece => ({
    piece: {
      ...{outline, alignment: {angle: 0, translation: [0, 0]}},
      ...{turns: 'any', up: [0, 1], shifts: []},
    },
    place: {angle: 0, translation: [16 + 30 * (k % 4), 18 + 32 * Math.floor(k / 4)]},
  }));
  for (const one of laid) turnsOf(one.piece, fabric);
  obstaclesTo(laid, 0, {angle: 0, translation: [30, 30]}, fabric); // fills the cache
  const move = () => {
    for (let k = 0; k < 60; k++)
      obstaclesTo(laid, 0, {angle: 0, translation: plus([70, 50], towards(k), 20)}, fabric);
  };
  expect(yardsticks(move)).toBeLessThan(0.25);
});

it('of the seams that are sure in a garment of 63 edges', async () => {
  const text = readFileSync('public/garments/hoodie-m.json', 'utf8');
  const garment = {...(await readGarment(text, 'hoodie')), seams: []};
  expect(garment.pieces.reduce((sum, {outline}) => sum + outline.length, 0)).toBe(63);
  expect(yardsticks(() => void sureSeams({...garment}))).toBeLessThan(1);
});
