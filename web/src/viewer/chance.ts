import type {Point} from '../model/geometry.js';
import {printDistance, type Repeat} from '../model/wallpaper.js';

const samples = 1024;
/** Steps of an evenly spread sequence in four dimensions: powers of 1 / x, where x^5 = x + 1. */
const steps = [1, 2, 3, 4].map((k) => 1.1673039782614187 ** -k);

/** The mean mismatch of two points of the print chosen at random: what a seam has when nothing is aligned. [cm] */
export function chanceMismatch(repeat: Repeat): number {
  const apart = printDistance(repeat);
  const {w1, w2} = repeat;
  let sum = 0;
  for (let n = 1; n <= samples; n++) {
    const [a = 0, b = 0, c = 0, d = 0] = steps.map((step) => (n * step) % 1);
    const at = (u: number, v: number): Point => [u * w1[0] + v * w2[0], u * w1[1] + v * w2[1]];
    sum += apart(at(a, b), at(c, d));
  }
  return sum / samples;
}
