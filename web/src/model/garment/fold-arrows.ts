/** Arrows of pleats: which line is laid on which. Lengths in cm. */
import {hidesFabric} from './folds.js';
import type {DraftedFold} from './garment-document.js';
import {nearestOn} from '../geometry/nearest.js';
import {middle, minus, plus, unit, type Point} from '../geometry/vectors.js';

/** Length of an arrowhead on paper. */
const onPaper = 0.6;

/**
 * Arrows between the lines of a pleat, each as a shaft and a head. A knife pleat and a tuck are
 * laid from one line onto the other; the lines of other pleats meet in the middle.
 * @param head length of an arrowhead
 */
export function foldArrows(
  fold: Pick<DraftedFold, 'kind' | 'line' | 'to'>,
  head = onPaper,
): readonly (readonly Point[])[] {
  const {kind, line, to} = fold;
  if (!to || !hidesFabric(fold)) return [];
  const from = middle(...line);
  const end = nearestOn(to, from, false).at;
  const meeting = middle(from, end);
  const shafts =
    kind === 'knife' || kind === 'tuck'
      ? [[from, end] as const]
      : [[from, meeting] as const, [end, meeting] as const];
  return shafts.flatMap(([tail, tip]) => {
    const [ux, uy] = unit(minus(tip, tail));
    const side: Point = [-uy, ux];
    const foot = plus(tip, [ux, uy], -head);
    return [
      [tail, tip],
      [plus(foot, side, head / 2), tip, plus(foot, side, -head / 2)],
    ];
  });
}
