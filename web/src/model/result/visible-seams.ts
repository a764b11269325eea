/** Counts of visible seams, by which complete answers are compared. */
import type {SolveResult} from './result.js';
import {seamCount, type SeamWeights} from './seam-groups.js';

/** The figures of an answer by which it is compared with others. */
export interface Standing {
  /** Number of seams that a headline counts, and how many of them match. */
  readonly visible: number;
  readonly matched: number;
  /** `answerCost` of its metrics. [cm2] */
  readonly answerCost: number;
}

type Compared = Pick<SolveResult, 'seamGroups'> & {
  readonly metrics: Pick<SolveResult['metrics'], 'answerCost'>;
};

/** @param weights the user's weights of seams, from the options of the problem */
export function standingOf(
  {seamGroups = [], metrics: {answerCost = 0}}: Compared,
  weights: SeamWeights,
): Standing {
  const {counted, matched} = seamCount(seamGroups, weights);
  return {visible: counted, matched, answerCost};
}

/** The figures of several garments together. */
export const together = (standings: readonly Standing[]): Standing =>
  standings.reduce(
    (sum, one) => ({
      visible: sum.visible + one.visible,
      matched: sum.matched + one.matched,
      answerCost: sum.answerCost + one.answerCost,
    }),
    {visible: 0, matched: 0, answerCost: 0},
  );

/** Returns whether more visible seams match; of equally many, whether the mismatch is less. */
export const isBetter = (one: Standing, other: Standing): boolean =>
  one.matched === other.matched ? one.answerCost < other.answerCost : one.matched > other.matched;
