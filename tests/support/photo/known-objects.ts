/** Objects of known size on photographed fabric. */
import type {Point} from '@/model/geometry/vectors.js';

import {applied, inverse, unlensed} from './camera.js';
import type {PrintTruth} from './case.js';
import {toGamma, toLinear} from './inks.js';
import type {Rgba} from './pixels.js';

/** Shape in cm from its middle, x along its width, and its brightness, 0 to 255. */
interface KnownThing {
  /** Greatest distance of its points from the middle. [cm] */
  readonly reach: number;
  /** Distance from the outline, negative within. [cm] */
  readonly outside: (x: number, y: number) => number;
  readonly shade: (x: number, y: number) => number;
}

/** A coin with an inner ring, like coins of two metals. */
export const coin = (diameter: number): KnownThing => ({
  reach: diameter / 2,
  outside: (x, y) => Math.hypot(x, y) - diameter / 2,
  shade: (x, y) => (Math.hypot(x, y) < 0.36 * diameter ? 168 : 214),
});

export const card = (width: number, height: number): KnownThing => ({
  reach: Math.hypot(width, height) / 2,
  outside: (x, y) => {
    const radius = 0.318; // corner radius by ISO/IEC 7810
    const [dx, dy] = [Math.abs(x) - width / 2 + radius, Math.abs(y) - height / 2 + radius];
    const corner = Math.hypot(Math.max(0, dx), Math.max(0, dy));
    return corner + Math.min(0, Math.max(dx, dy)) - radius;
  },
  shade: (_, y) => (y > 0.2 * height ? 90 : 232),
});

/** Larger than a pixel. [cm] */
const margin = 0.2;
/** Number of samples in a pixel, in each direction. */
const samples = 4;

/** Soft shadow around an object, deepest at its edge. */
interface ContactShadow {
  /** Share of the light that is missing at the edge. */
  readonly depth: number;
  /** Distance from the edge at which it ends. [cm] */
  readonly width: number;
}

const noShadow: ContactShadow = {depth: 0, width: 1};

/** A code of 0 to 255 in a part of the light. */
const shaded = (code: number, lit: number): number =>
  lit < 1 ? 255 * toGamma(lit * toLinear(code / 255)) : code;

/** Draws the object on the fabric, its middle at a pixel. @param turn  counter-clockwise. [rad] */
export function withThing(
  {width, height, data}: Rgba,
  {w1, w2, ...view}: PrintTruth,
  thing: KnownThing,
  {
    at,
    turn = 0,
    shadow = noShadow,
  }: {readonly at: Point; readonly turn?: number; readonly shadow?: ContactShadow},
): Rgba {
  const back = inverse(view.homography);
  const [cx, cy] = view.lensMiddle;
  const onFabric = ([x, y]: Point): Point => {
    const factor = unlensed(view, (x - cx) ** 2 + (y - cy) ** 2);
    const [u, v] = applied(back, [cx + factor * (x - cx), cy + factor * (y - cy)]);
    return [u * w1[0] + v * w2[0], u * w1[1] + v * w2[1]];
  };
  const middle = onFabric(at);
  const reach = thing.reach + margin + (shadow.depth > 0 ? shadow.width : 0);
  const [cos, sin] = [Math.cos(turn), Math.sin(turn)];
  const drawn = new Uint8ClampedArray(data);
  for (let y = 0; y < height; y++) {
    for (let x = 0; x < width; x++) {
      const centre = onFabric([x + 0.5, y + 0.5]);
      if (Math.hypot(centre[0] - middle[0], centre[1] - middle[1]) > reach) continue;
      let [light, covered, shade] = [0, 0, 0];
      for (let part = 0; part < samples * samples; part++) {
        const [px, py] = onFabric([
          x + ((part % samples) + 0.5) / samples,
          y + (Math.floor(part / samples) + 0.5) / samples,
        ]);
        const [dx, dy] = [px - middle[0], py - middle[1]];
        const [along, up] = [cos * dx + sin * dy, cos * dy - sin * dx];
        const outside = thing.outside(along, up);
        if (outside >= 0) {
          shade += shadow.depth * Math.max(0, 1 - outside / shadow.width) ** 2;
          continue;
        }
        covered += 1;
        light += thing.shade(along, up);
      }
      const share = covered / (samples * samples);
      const lit = 1 - shade / Math.max(1, samples * samples - covered);
      for (let channel = 0; channel < 3; channel++) {
        const k = 4 * (y * width + x) + channel;
        drawn[k] = (1 - share) * shaded(data[k] ?? 0, lit) + (share * light) / Math.max(1, covered);
      }
    }
  }
  return {width, height, data: drawn};
}
