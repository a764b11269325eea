/** The print of a result, in the size and turn of the result. */
import {distance, norm} from '../geometry/vectors.js';
import {asVariant} from '../print/print-variant.js';
import type {Print} from '../print/repeating-print.js';
import type {SolveResult} from './result.js';

/** Greatest difference of equal repeats, as a share: the solver corrects rounded lattices. */
const sameRepeat = 1e-5;

/**
 * The print of a result in its size and turn, made from the print in those or in its own.
 * Undefined if it has another group or repeat.
 */
export function printOfResult<P extends Print>(
  {group, w1, w2, scale = 1, turnDeg = 0}: SolveResult['print'],
  print: P,
): P | undefined {
  const own = {w1, w2};
  const varied = {
    scale: scale / (print.scale ?? 1),
    turnDeg: turnDeg - (print.turnDeg ?? 0),
  };
  return [print, asVariant(print, varied)].find(
    (one) =>
      one.group === group &&
      (['w1', 'w2'] as const).every((w) => distance(own[w], one[w]) < sameRepeat * norm(one[w])),
  );
}
