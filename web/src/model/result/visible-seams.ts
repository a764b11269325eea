/** Counts of visible seams, by which complete answers are compared. */
import type {SolveResult} from './result.js';

/** Least visibility of a seam that is seen at first sight. */
export const leastVisible = 1.5;

/** Number of visible seams, without those that the user has left out, and how many match. */
export function visibleSeams({seamGroups = []}: Pick<SolveResult, 'seamGroups'>): {
  readonly visible: number;
  readonly matched: number;
} {
  const seen = seamGroups.filter(
    ({visibility, state}) => visibility >= leastVisible && state !== 'choice',
  );
  const matched = seen.filter(({state}) => state === 'matches');
  return {visible: seen.length, matched: matched.length};
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
