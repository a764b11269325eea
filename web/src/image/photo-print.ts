/** Converts the reading of a photo to a print. */
import type {Point} from '../model/geometry/vectors.js';
import type {PhotoReading} from '../model/print/photo-reading.js';
import type {Print} from '../model/print/repeating-print.js';
import {latticeVectors, repeatOf} from '../model/print/repeat.js';

/** Width of prints of unknown size, for a preview on a garment. [cm] */
export const assumedWidth = 10;

/** Returns whether a reading has symmetries that can be made exact. */
export const isSymmetric = ({group}: Pick<PhotoReading, 'group'>): boolean => group !== 'p1';

type ReadPrint = Pick<PhotoReading, 'group' | 'w1' | 'w2' | 'shape' | 'oneWay'>;

/**
 * Steps of lengths and angles: a micrometre and a thousandth of a degree, finer than any
 * measurement of fabric. [cm, degrees]
 */
const lengthStep = 1e-4;
const angleStep = 1e-3;
/**
 * Step of vector coordinates, below which cosines have rounding errors. Readers of prints accept an
 * error of a millionth. [cm]
 */
const vectorStep = 1e-7;

/** Rounds, and never returns -0. */
const rounded = (value: number, step: number): number =>
  Math.round(value / step) / Math.round(1 / step) + 0;

const crisp = ([x, y]: Point): Point => [rounded(x, vectorStep), rounded(y, vectorStep)];

/** The repeat of a lattice in rounded numbers, for display and files. */
export function readableRepeat(
  lattice: Parameters<typeof repeatOf>[0],
): ReturnType<typeof repeatOf> {
  const {size, turnDeg} = repeatOf(lattice);
  const {width, height, angleDeg} = size;
  return {
    size: {
      width: rounded(width, lengthStep),
      height: rounded(height, lengthStep),
      angleDeg: rounded(angleDeg, angleStep),
    },
    turnDeg: rounded(turnDeg, angleStep),
  };
}

/** The print, without an image. Its vectors follow from the rounded repeat and the group. */
export function printOfPhoto({group, w1, w2, shape, oneWay}: ReadPrint): Print {
  const isScaled = w1 !== null && w2 !== null;
  const [a, b] = isScaled ? [w1, w2] : shape;
  const factor = isScaled ? 1 : assumedWidth;
  const scaled = ([x, y]: Point): Point => [factor * x, factor * y];
  const {size, turnDeg} = readableRepeat({group, w1: scaled(a), w2: scaled(b)});
  const [first, second] = latticeVectors(group, size, turnDeg);
  return {
    ...{format: 'seamwise-print/1', group, w1: crisp(first), w2: crisp(second)},
    ...{cell: 'primitive', oneWay},
    ...(!isScaled && {unscaled: true}),
  };
}
