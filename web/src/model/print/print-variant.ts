/** The same print in another size, or turned on its fabric. */
import {atScale, scaleBetween, settled} from './print-scale.js';
import {latticeVectors, repeatOf, wrappedTurn, type PrintRepeat} from './repeat.js';
import type {Print} from './repeating-print.js';

/** Size and turn of a print, relative to another one, usually that of its file. */
export interface PrintVariant {
  /** Multiple of the size. */
  readonly scale: number;
  /** Counter-clockwise turn. [degrees] */
  readonly turnDeg: number;
}

/** Greatest turn of a print, in both directions. [degrees] */
export const mostTurn = 180;

/** The repeat in another size, and turned. */
export function variedRepeat({size, turnDeg}: PrintRepeat, variant: PrintVariant): PrintRepeat {
  const {width, height, angleDeg} = size;
  const {scale} = variant;
  return {
    size: scale === 1 ? size : {width: scale * width, height: scale * height, angleDeg},
    turnDeg: variant.turnDeg === 0 ? turnDeg : wrappedTurn(turnDeg + variant.turnDeg),
  };
}

/**
 * The variant that leads from one repeat to another; undefined if their proportions differ, or if
 * the scale is outside the limits.
 */
export function variantBetween(own: PrintRepeat, other: PrintRepeat): PrintVariant | undefined {
  const scale = scaleBetween(own.size, other.size);
  return scale === undefined
    ? undefined
    : {scale, turnDeg: roundedTurn(other.turnDeg - own.turnDeg)};
}

const roundedTurn = (degrees: number): number => Number(wrappedTurn(degrees).toFixed(9));

type Varied = Pick<Print, 'group' | 'w1' | 'w2' | 'cell' | 'scale' | 'turnDeg'>;

/** The print in another size, and turned. Its `scale` and `turnDeg` still refer to its file. */
export const asVariant = <P extends Varied>(print: P, variant: PrintVariant): P =>
  variant.turnDeg === 0
    ? atScale(print, variant.scale)
    : withRepeat(print, variedRepeat(repeatOf(print), variant));

/** The print with another repeat; a variant is marked as one. */
export function withRepeat<P extends Varied>(print: P, repeat: PrintRepeat): P {
  const variant = variantBetween(repeatOf(print), repeat);
  if (variant?.turnDeg === 0) return atScale(print, variant.scale);
  const [w1, w2] = latticeVectors(print.group, repeat.size, repeat.turnDeg, print.cell);
  const turned = {...print, w1: settled(w1), w2: settled(w2)};
  if (!variant) return turned;
  const {scale} = atScale(print, variant.scale);
  return {
    ...turned,
    ...(scale !== undefined && {scale}),
    turnDeg: roundedTurn((print.turnDeg ?? 0) + variant.turnDeg),
  };
}
