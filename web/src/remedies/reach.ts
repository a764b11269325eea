/** Finds seams that the print cannot match even where no other seam counts. */
import type {SingleProblem} from '../model/design/solve-problem.js';
import type {SeamGroup, SolveResult} from '../model/result/result.js';
import {leastVisible} from '../model/result/seam-groups.js';
import {parsed, withRemedy} from './remedy.js';

/** Greatest number of seams that are tried, the most visible first, since each takes a solve. */
const most = 4;

const isCandidate = ({state, reason, visibility}: SeamGroup): boolean =>
  state === 'off' && visibility >= leastVisible && (reason === 'others' || reason === 'size');

/**
 * Solves each visible seam by itself, by method `best` only. A seam that is still off cannot match.
 * @returns the result, in which the state of such seams is `cannot` and the reason `reach`
 * @throws the signal's reason when it aborts
 */
export async function withReach(
  problem: SingleProblem,
  result: SolveResult,
  solve: (problem: SingleProblem, signal?: AbortSignal) => Promise<SolveResult>,
  {signal}: {readonly signal?: AbortSignal | undefined} = {},
): Promise<SolveResult> {
  const groups = result.metrics.method === 'best' ? (result.seamGroups ?? []) : [];
  const tried = groups
    .filter(isCandidate)
    .toSorted((one, other) => other.visibility - one.visibility)
    .slice(0, most);
  const beyond = new Set<SeamGroup>();
  const {unmatched = []} = parsed(problem.options);
  for (const group of tried) {
    const others = result.seams.flatMap((_, k) => (group.seams.includes(k) ? [] : [k]));
    const options = {unmatched: [...new Set([...unmatched, ...others])].sort((a, b) => a - b)};
    const alone = await solve(withRemedy(problem, {options}), signal).catch(() => undefined);
    signal?.throwIfAborted();
    const same = alone?.seamGroups?.find(({seams}) => seams[0] === group.seams[0]);
    if (same?.state === 'off' || same?.state === 'cannot') beyond.add(group);
  }
  if (beyond.size === 0) return result;
  const seamGroups = groups.map((group): SeamGroup =>
    beyond.has(group) ? {...group, state: 'cannot', reason: 'reach'} : group,
  );
  return {...result, seamGroups};
}
