/** Counts of visible seams, by which complete answers are compared. */
import type {SolveResult} from './result.js';
import {seamCount} from './seam-groups.js';

/** Number of seams that a headline counts, and how many of them match. */
export function visibleSeams({seamGroups = []}: Pick<SolveResult, 'seamGroups'>): {
  readonly visible: number;
  readonly matched: number;
} {
  const {counted, matched} = seamCount(seamGroups, undefined);
  return {visible: counted, matched};
}

type Compared = Pick<SolveResult, 'seamGroups'> & {
  readonly metrics: Pick<SolveResult['metrics'], 'answerCost'>;
};

/** Returns whether more visible seams match; of equally many, whether the mismatch is less. */
export function isBetter(one: Compared, other: Compared): boolean {
  const gained = visibleSeams(one).matched - visibleSeams(other).matched;
  const cost = ({metrics: {answerCost = 0}}: Compared): number => answerCost;
  return gained === 0 ? cost(one) < cost(other) : gained > 0;
}
