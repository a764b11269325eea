/** Colours of inks and fabrics. */
import type {Chance} from './chance.js';

/** Red, green, blue, linear light, in [0, 1]. */
export type Ink = readonly [number, number, number];

export const toLinear = (x: number): number =>
  x <= 0.04045 ? x / 12.92 : ((x + 0.055) / 1.055) ** 2.4;
export const toGamma = (x: number): number =>
  x <= 0.0031308 ? 12.92 * x : 1.055 * x ** (1 / 2.4) - 0.055;

/** Converts gamma-coded red, green, blue in [0, 1]. */
const ink = (r: number, g: number, b: number): Ink => [toLinear(r), toLinear(g), toLinear(b)];

/** @param hue  in turns @param value  the greatest of the three, gamma-coded */
export function inkOf(hue: number, saturation: number, value: number): Ink {
  const part = (shift: number): number => {
    const k = (shift + 6 * hue) % 6;
    return value * (1 - saturation * Math.max(0, Math.min(k, 4 - k, 1)));
  };
  return ink(part(5), part(3), part(1));
}

interface Palette {
  readonly ground: Ink;
  readonly inks: readonly Ink[];
}

/** A light or a dark ground, and four or five inks in contrast to it. */
export function palette(chance: Chance): Palette {
  const dark = chance.happens(0.3);
  const hue = chance.next();
  const ground = dark
    ? inkOf(hue, chance.between(0.3, 0.8), chance.between(0.12, 0.3))
    : inkOf(hue, chance.between(0.02, 0.2), chance.between(0.82, 0.95));
  const inks = Array.from({length: chance.whole(4, 5)}, (_, k) =>
    inkOf(
      (hue + 0.25 + 0.19 * k + chance.between(-0.06, 0.06)) % 1,
      chance.between(0.35, 0.85),
      dark ? chance.between(0.5, 0.95) : chance.between(0.25, 0.75),
    ),
  );
  return {ground, inks};
}
