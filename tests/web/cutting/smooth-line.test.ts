/** Edges drawn as curves through their points before they get an allowance. */
import {expect, it} from 'vitest';

import {bandOf} from '@/cutting/corners.js';
import {smoothLine} from '@/cutting/edges.js';
import {distance, minus, turnBetween, type Point} from '@/model/geometry/vectors.js';

/** An arc about the origin in steps of about 1 cm. */
const arc = (radius: number, turn: number): Point[] => {
  const count = Math.round(radius * turn);
  return Array.from({length: count + 1}, (_, k): Point => {
    const at = -((turn * k) / count);
    return [radius * Math.cos(at), radius * Math.sin(at)];
  });
};

const sharpest = (line: readonly Point[]): number =>
  Math.max(
    ...line.slice(2).map((c, k) => {
      const [a = c, b = c] = line.slice(k, k + 2);
      return Math.abs(turnBetween(minus(b, a), minus(c, b)));
    }),
  );

it.each([6, 12, 30])('an armhole of radius %s cm is round, sewn and cut', (radius) => {
  const coarse = arc(radius, 2);
  const line = smoothLine(coarse);
  expect(sharpest(coarse)).toBeGreaterThan(0.9 / radius);
  for (const drawn of [line, bandOf(line, 1).cut]) expect(sharpest(drawn)).toBeLessThan(0.05);
  for (const p of line) expect(Math.abs(distance(p, [0, 0]) - radius)).toBeLessThan(0.002);
  // its own points stay
  for (const p of coarse) expect(line).toContainEqual(p);
});

it('leaves what is straight, coarse or a corner as it is', () => {
  const straight = Array.from({length: 20}, (_, k): Point => [k, 0.3 * k]);
  const coarse: Point[] = [
    [0, 0],
    [5, 1],
    [10, 3],
  ];
  const corner: Point[] = [
    [0, 0],
    [1, 0],
    [2, 0],
    [2, 1],
    [2, 2],
  ];
  for (const line of [straight, coarse, corner]) expect(smoothLine(line)).toEqual(line);
});
