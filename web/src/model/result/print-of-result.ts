/** The print of a result, in the size and turn of the result. */
import {distance, norm} from '../geometry/vectors.js';
import {asSewn, deliveredIn, isSameFabric, withFabric} from '../print/as-sewn.js';
import {asVariant} from '../print/print-variant.js';
import type {Delivered, Print} from '../print/repeating-print.js';
import type {SolveResult} from './result.js';

/** Greatest difference of equal repeats, as a share: the solver corrects rounded lattices. */
const sameRepeat = 1e-5;

/** Returns whether a print states other values of its fabric than those of a result. */
const contradicts = (
  {shrinkage, measured}: Delivered = {},
  {shrinkage: share, measured: repeat}: Delivered = {},
): boolean =>
  (share !== undefined && !isSameFabric({shrinkage: share}, {...(shrinkage && {shrinkage})})) ||
  (repeat !== undefined && !isSameFabric({measured: repeat}, {...(measured && {measured})}));

/**
 * The print of a result in its size and turn, made from the print in those or in its own.
 * Undefined if it has another group or repeat, or other fabric.
 */
export function printOfResult<P extends Print>(
  {group, w1, w2, scale = 1, turnDeg = 0, delivered}: SolveResult['print'],
  print: P,
): P | undefined {
  const own = {w1, w2};
  const varied = {
    scale: scale / (print.scale ?? 1),
    turnDeg: turnDeg - (print.turnDeg ?? 0),
  };
  const sewn = (one: P): P =>
    delivered && !one.delivered ? asSewn(withFabric(one, delivered)) : one;
  return [sewn(print), sewn(asVariant(print, varied))].find(
    (one) =>
      one.group === group &&
      !contradicts(delivered, print.delivered ?? deliveredIn(print)) &&
      (['w1', 'w2'] as const).every((w) => distance(own[w], one[w]) < sameRepeat * norm(one[w])),
  );
}

/**
 * The difference between the fabric of a result and that of its print's file, as a sentence;
 * undefined if there is none.
 */
export function fabricConflict(
  {delivered}: SolveResult['print'],
  print: Pick<Print, 'fabric' | 'delivered'>,
): string | undefined {
  const stated = print.delivered ?? deliveredIn(print);
  if (!stated || !contradicts(delivered, stated)) return undefined;
  return `The print has ${fabricWords(stated)}, but the result was solved for ${fabricWords(delivered)}; align it again, or correct the print.`;
}

/** "shrinkage of 3 % along the warp and 2 % along the weft, and a measured repeat of 10.1 x 9.9 cm" */
function fabricWords({shrinkage, measured}: Delivered = {}): string {
  const {across = 'as stated', up = 'as stated'} = measured ?? {};
  const words = [
    ...(shrinkage
      ? [`shrinkage of ${shrinkage.warp} % along the warp and ${shrinkage.weft} % along the weft`]
      : []),
    ...(measured ? [`a measured repeat of ${across} x ${up} cm`] : []),
  ];
  return words.length > 0 ? words.join(' and ') : 'fabric as stated';
}
