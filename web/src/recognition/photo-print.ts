/** What was read off a picture, as a print. */
import type {Point} from '../model/geometry.js';
import type {PhotoReading} from '../model/photo.js';
import type {Print} from '../model/print.js';

/** Of prints whose size nobody knows yet: so wide that a print can be judged on a garment. [cm] */
export const assumedWidth = 10;

/** Whether anything of it could be made exact. */
export const isSymmetric = ({group}: Pick<PhotoReading, 'group'>): boolean => group !== 'p1';

type ReadPrint = Pick<PhotoReading, 'group' | 'w1' | 'w2' | 'shape' | 'oneWay'>;

/** Without a picture. Lengths are rounded to what a design stores. */
export function printOfPhoto({group, w1, w2, shape, oneWay}: ReadPrint): Print {
  const isScaled = w1 !== null && w2 !== null;
  const [a, b] = isScaled ? [w1, w2] : shape;
  const factor = isScaled ? 1 : assumedWidth;
  const scaled = ([x, y]: Point): Point => [factor * x, factor * y];
  return {
    ...{format: 'seamwise-print/1', group, w1: scaled(a), w2: scaled(b), cell: 'primitive', oneWay},
    ...(!isScaled && {unscaled: true}),
  };
}
