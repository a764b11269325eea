/** Tries proposals for a result, and keeps those that help. */
import type {SingleProblem} from '../model/design/solve-problem.js';
import type {SolveResult} from '../model/result/result.js';
import {countedSeams, finalMismatch, meanOf, type PatternMismatch} from '../scene/mismatch.js';
import {proposals} from './proposals.js';
import {withRemedy, type Proposal, type Remedy} from './remedy.js';

/**
 * Greatest remaining share of the mismatch for each remedy. Half the repeat halves the mismatch
 * anyway.
 */
const leftAtMost = {turn: 0.6, ungather: 0.6, mirrors: 0.6, smaller: 0.35} as const;
/** Least improvement. [cm] */
const leastGain = 0.1;
/** Greatest increase of the mean over all seams. [cm] */
const patience = 0.02;

interface RemedyHooks {
  readonly signal?: AbortSignal | undefined;
  /** Resolves when another solve would not disturb. */
  readonly idle?: () => Promise<void>;
  /** Called as soon as a remedy is found. */
  readonly onRemedy?: (remedy: Remedy) => void;
}

/**
 * Solves the problem with each proposal in turn. A proposal that cannot be solved is no remedy.
 * @throws the signal's reason when it aborts
 */
export async function remediesOf(
  problem: SingleProblem,
  result: SolveResult,
  solve: (problem: SingleProblem, signal?: AbortSignal) => Promise<SolveResult>,
  {signal, idle, onRemedy}: RemedyHooks = {},
): Promise<readonly Remedy[]> {
  const found: Remedy[] = [];
  for (const proposal of proposals(problem, result)) {
    await idle?.();
    signal?.throwIfAborted();
    const tried = await solve(withRemedy(problem, proposal.change), signal).catch(() => undefined);
    signal?.throwIfAborted();
    const remedy = tried && asRemedy(proposal, result, tried);
    if (!remedy) continue;
    found.push(remedy);
    onRemedy?.(remedy);
  }
  return found;
}

/** The remedy; undefined without a clear improvement. */
function asRemedy(proposal: Proposal, result: SolveResult, tried: SolveResult): Remedy | undefined {
  // compares the same seams in both results, since other symmetries make other seams match
  // trivially
  const counted = countedSeams(result);
  const left = counted.map((counts, k) => counts && tried.seams[k]?.matched !== false);
  const [before, after] = [finalMismatch(result, counted), finalMismatch(tried, left)];
  const [was, is] =
    proposal.kind === 'ungather'
      ? [before.mean, after.mean]
      : [meanAlong(before, proposal.seams), meanAlong(after, proposal.seams)];
  const helps = is <= leftAtMost[proposal.kind] * was && was - is >= leastGain;
  return helps && after.mean <= before.mean + patience
    ? {...proposal, before: was, after: is}
    : undefined;
}

function meanAlong({seams}: PatternMismatch, numbers: readonly number[]): number {
  const some = numbers.flatMap((number) => seams.slice(number, number + 1));
  return meanOf({
    mismatch: some.flatMap(({mismatch}) => mismatch),
    lengths: some.flatMap(({lengths}) => lengths),
  });
}
