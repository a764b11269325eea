/** The print of a result, in the size of the result. */
import {distance, norm} from '../geometry/vectors.js';
import {atScale} from '../print/print-scale.js';
import type {Print} from '../print/repeating-print.js';
import type {SolveResult} from './result.js';

/** Greatest difference of equal repeats, as a share: the solver corrects rounded lattices. */
const sameRepeat = 1e-5;

/**
 * The print of a result in the size of the result, made from the print in that size or in its own.
 * Undefined if it has another group or repeat.
 */
export function printOfResult<P extends Print>(
  {group, w1, w2, scale = 1}: SolveResult['print'],
  print: P,
): P | undefined {
  const own = {w1, w2};
  return [print, atScale(print, scale / (print.scale ?? 1))].find(
    (one) =>
      one.group === group &&
      (['w1', 'w2'] as const).every((w) => distance(own[w], one[w]) < sameRepeat * norm(one[w])),
  );
}
