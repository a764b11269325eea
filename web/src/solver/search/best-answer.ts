/** Solves a problem in several sizes and turns and with several seeds, and takes the best answer. */
import type {Progress} from '../../model/design/solve-problem.js';
import type {PrintVariant} from '../../model/print/print-variant.js';
import {isBetter, type Standing} from '../../model/result/visible-seams.js';
import type {NamedSolveHooks} from '../requests/requests.js';
import type {AskedSearch} from './asked-search.js';

/** Greatest number of seeds: eight times the effort of one solve. */
const mostSeeds = 8;
/** Number of seeds in a row without a better answer after which the search ends. */
const patience = 4;
const seedCount = 2 ** 32;

/** A search, and how it solves and compares. */
interface Comparing<Answer> {
  readonly search: Pick<AskedSearch, 'seed' | 'scales' | 'turns' | 'isLong'>;
  readonly solve: (variant: PrintVariant, seed: number, hooks: NamedSolveHooks) => Promise<Answer>;
  readonly standingOf: (answer: Answer) => Standing;
}

interface Best<Answer> {
  readonly variant: PrintVariant;
  readonly answer: Answer;
  readonly standing: Standing;
}

/**
 * First all turns and then all sizes with the first seed, then other seeds in the best turn and
 * size. It ends early when every visible seam matches. The order and the number of solves depend
 * only on the problem, so the answer does, too. A turn or size other than the print's own that
 * cannot be solved is not taken.
 * @throws errors of the first solve; the signal's reason
 */
export async function bestAnswer<Answer>(
  {search, solve, standingOf}: Comparing<Answer>,
  hooks: NamedSolveHooks = {},
): Promise<Answer> {
  const {seed: firstSeed, scales, turns, isLong} = search;
  const {signal, names, onPattern, onPartial, onCompared, onRefused, onProgress} = hooks;
  const count = turns.length + scales.length - 1 + (isLong ? mostSeeds - 1 : 0);
  let done = 0;
  let best: Best<Answer> | undefined;

  const attempt = async (variant: PrintVariant, seed: number): Promise<boolean> => {
    const answer = await solve(variant, seed, {
      ...(signal && {signal}),
      ...(names && {names}),
      // the intermediate results of one solve, since those of several would jump
      ...(done === 0 && {...(onPattern && {onPattern}), ...(onPartial && {onPartial})}),
      ...(onProgress && {onProgress: share(onProgress, done, count)}),
    });
    const standing = standingOf(answer);
    const isBest = !best || isBetter(standing, best.standing);
    const {scale, turnDeg} = variant;
    onCompared?.({scale, ...(turnDeg !== 0 && {turnDeg}), seed, ...standing, isBest});
    if (isBest) best = {variant, answer, standing};
    return isBest;
  };

  const allMatch = (): boolean => best?.standing.visible === best?.standing.matched;

  const attemptVariant = async (variant: PrintVariant): Promise<void> => {
    const first = !best;
    if (!first && allMatch()) return;
    await attempt(variant, firstSeed).catch((error: unknown) => {
      if (first || signal?.aborted) throw error;
      onRefused?.({...variant, reason: error});
    });
    done += 1;
  };

  const [own = 1, ...others] = scales;
  for (const turnDeg of turns) await attemptVariant({scale: own, turnDeg});
  const turned = best?.variant.turnDeg ?? 0;
  for (const scale of others) await attemptVariant({scale, turnDeg: turned});
  let vain = 0;
  for (let k = 1; best && isLong && k < mostSeeds && vain < patience && !allMatch(); ++k) {
    const isGain = await attempt(best.variant, (firstSeed + k) % seedCount);
    vain = isGain ? 0 : vain + 1;
    done += 1;
  }
  onProgress?.({phase: 'deformation', fraction: 1});
  if (!best) throw new Error('There are no sizes to solve.');
  return best.answer;
}

/** Reports the progress of one of `count` solves as a share of all. */
const share =
  (onProgress: (progress: Progress) => void, done: number, count: number) =>
  ({phase, fraction}: Progress): void => {
    onProgress({phase, fraction: (done + fraction) / count});
  };
