/** Solves a problem in several sizes and with several seeds, and takes the best answer. */
import type {Progress, SingleProblem} from '../../model/design/solve-problem.js';
import type {SolveResult} from '../../model/result/result.js';
import {isBetter, visibleSeams} from '../../model/result/visible-seams.js';
import type {NamedSolveHooks} from '../requests/requests.js';
import type {AskedSearch} from './asked-search.js';

/** Greatest number of seeds: eight times the effort of one solve. */
const mostSeeds = 8;
/** Number of seeds in a row without a better answer after which the search ends. */
const patience = 4;
const seedCount = 2 ** 32;

type Solve = (problem: SingleProblem, hooks: NamedSolveHooks) => Promise<SolveResult>;

/**
 * First all sizes with the first seed, then other seeds in the best size. It ends early when every
 * visible seam matches. The order and the number of solves depend only on the problem, so the
 * answer does, too. A size other than the print's own that cannot be solved is not taken.
 * @param solve solves one problem
 * @throws errors of the first solve; the signal's reason
 */
export async function bestAnswer(
  {problemAt, seed: firstSeed, scales, isLong}: AskedSearch,
  solve: Solve,
  hooks: NamedSolveHooks,
): Promise<SolveResult> {
  const {signal, names, onPattern, onPartial, onCompared, onRefused, onProgress} = hooks;
  const count = scales.length + (isLong ? mostSeeds - 1 : 0);
  let done = 0;
  let best: {readonly scale: number; readonly result: SolveResult} | undefined;

  const attempt = async (scale: number, seed: number): Promise<boolean> => {
    const result = await solve(
      {...problemAt(scale), seed},
      {
        ...(signal && {signal}),
        ...(names && {names}),
        // the intermediate results of one solve, since those of several would jump
        ...(done === 0 && {...(onPattern && {onPattern}), ...(onPartial && {onPartial})}),
        ...(onProgress && {onProgress: share(onProgress, done, count)}),
      },
    );
    const isBest = !best || isBetter(result, best.result);
    onCompared?.({
      ...{scale, seed, ...visibleSeams(result)},
      ...{answerCost: result.metrics.answerCost ?? 0, isBest},
    });
    if (isBest) best = {scale, result};
    return isBest;
  };

  const allMatch = (): boolean => {
    const {visible, matched} = visibleSeams(best?.result ?? {});
    return visible === matched;
  };

  for (const scale of scales) {
    if (best && allMatch()) break;
    const first = !best;
    await attempt(scale, firstSeed).catch((error: unknown) => {
      if (first || signal?.aborted) throw error;
      onRefused?.({scale, reason: error});
    });
    done += 1;
  }
  let vain = 0;
  for (let k = 1; isLong && k < mostSeeds && vain < patience && !allMatch(); ++k) {
    const isGain = await attempt(best?.scale ?? 1, (firstSeed + k) % seedCount);
    vain = isGain ? 0 : vain + 1;
    done += 1;
  }
  onProgress?.({phase: 'deformation', fraction: 1});
  if (!best) throw new Error('There are no sizes to solve.');
  return best.result;
}

/** Reports the progress of one of `count` solves as a share of all. */
const share =
  (onProgress: (progress: Progress) => void, done: number, count: number) =>
  ({phase, fraction}: Progress): void => {
    onProgress({phase, fraction: (done + fraction) / count});
  };
