/** The same print in another size. */
import type {Point} from '../geometry/vectors.js';
import type {Print} from './repeating-print.js';

/** Scales that a print size may have. */
export const scaleLimits = [0.5, 2] as const;

/** Rounds a scale, more finely than any printer needs. */
const rounded = (scale: number): number => Number(scale.toFixed(9));

/**
 * Rounds a vector, because browsers differ in the last digit of a sine and results must not. [cm]
 */
export const settled = ([x, y]: Point): Point => [
  Math.round(x * 1e9) / 1e9 + 0,
  Math.round(y * 1e9) / 1e9 + 0,
];

/** The print with `scale` times its size. Its `scale` still refers to the file of the print. */
export function atScale<P extends Pick<Print, 'w1' | 'w2' | 'scale'>>(print: P, scale: number): P {
  if (scale === 1) return print;
  const scaled = ([x, y]: Point): Point => settled([scale * x, scale * y]);
  const before = print.scale ?? 1;
  return {
    ...print,
    ...{w1: scaled(print.w1), w2: scaled(print.w2)},
    scale: rounded(scale * before),
  };
}

interface Size {
  readonly width: number;
  readonly height: number;
  readonly angleDeg: number;
}

/**
 * The scale from one size of a repeat to another; undefined if their proportions differ, or if the
 * scale is outside the limits.
 */
export function scaleBetween(own: Size, other: Size): number | undefined {
  const [across, up] = [other.width / own.width, other.height / own.height];
  const [least, most] = scaleLimits;
  const isSimilar = Math.abs(across - up) < 1e-9 && Math.abs(own.angleDeg - other.angleDeg) < 1e-9;
  const scale = rounded(across);
  return isSimilar && scale >= least && scale <= most ? scale : undefined;
}

/** Least and greatest resolution of the picture of a repeat. [dots per inch] */
export const dpiLimits = [30, 1200] as const;
