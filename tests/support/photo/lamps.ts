/** Light over an image: two lamps, the lens's vignetting, their colour. */
import type {Chance} from './chance.js';
import type {Ink} from './inks.js';

export interface Lamps {
  /** Least over greatest light in the image. */
  readonly least: number;
  /** Share of light lost in the corners. */
  readonly vignette: number;
  /** Factor per colour, around 1. */
  readonly cast: Ink;
}

/** Light per colour at a pixel; the greatest is 1 where the cast is. */
export function lightOf(
  {least, vignette, cast}: Lamps,
  width: number,
  height: number,
  chance: Chance,
): (x: number, y: number, out: Float32Array) => void {
  const longer = Math.max(width, height);
  const lamp = (): ((x: number, y: number) => number) => {
    const angle = chance.between(0, 2 * Math.PI);
    const away = longer * chance.between(0.3, 1);
    const lx = width / 2 + away * Math.cos(angle);
    const ly = height / 2 + away * Math.sin(angle);
    const above = (longer * chance.between(0.7, 1.4)) ** 2;
    return (x, y) => above / (above + (x - lx) ** 2 + (y - ly) ** 2);
  };
  const first = lamp();
  const second = lamp();
  const share = chance.between(0.3, 0.7);
  const half = (width * width + height * height) / 4;
  const raw = (x: number, y: number): number => {
    const r = ((x - width / 2) ** 2 + (y - height / 2) ** 2) / half;
    return (share * first(x, y) + (1 - share) * second(x, y)) * (1 - vignette * r);
  };
  let low = Infinity;
  let high = 0;
  for (let j = 0; j <= 20; j++) {
    for (let i = 0; i <= 20; i++) {
      const value = raw((i / 20) * width, (j / 20) * height);
      low = Math.min(low, value);
      high = Math.max(high, value);
    }
  }
  // exponent that gives the darkest place the required light
  const power = Math.log(least) / Math.log(low / high);
  const [red, green, blue] = cast;
  return (x, y, out) => {
    const value = Math.exp(power * Math.log(raw(x, y) / high));
    out[0] = red * value;
    out[1] = green * value;
    out[2] = blue * value;
  };
}

/** @param most  greatest deviation of each colour */
export const castOf = (most: number, chance: Chance): Ink => [
  chance.between(1 - most, 1 + most),
  chance.between(1 - most, 1 + most),
  chance.between(1 - most, 1 + most),
];
