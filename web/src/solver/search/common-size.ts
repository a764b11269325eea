/** The one size of the print in which several garments match best together. */
import {isBetter, type Standing} from '../../model/result/visible-seams.js';

/** A compared size, with the sums over all garments. */
export interface ComparedSize extends Standing {
  /** Size of the print, as a multiple of its own. */
  readonly scale: number;
  /** True if it is better than all sizes before. */
  readonly isBest: boolean;
}

interface Comparing {
  /** Sizes to compare, the print's own first. */
  readonly scales: readonly number[];
  /** Solves one garment in a size. */
  readonly standingOf: (garment: number, scale: number) => Promise<Standing>;
  readonly onCompared?: (size: ComparedSize) => void;
  /** Receives a size in which a garment cannot be solved, and the reason. */
  readonly onRefused?: (scale: number, reason: unknown) => void;
  readonly signal?: AbortSignal;
}

const sum = (one: Standing, other: Standing): Standing => ({
  visible: one.visible + other.visible,
  matched: one.matched + other.matched,
  answerCost: one.answerCost + other.answerCost,
});

/**
 * Compares sizes by the matching seams of all garments. It ends early when all of them match.
 * @param count number of garments
 * @throws errors of the first size; the signal's reason
 */
export async function commonSize(
  count: number,
  {scales, standingOf, onCompared, onRefused, signal}: Comparing,
): Promise<number> {
  let best: ComparedSize | undefined;
  for (const scale of scales) {
    try {
      let all: Standing = {visible: 0, matched: 0, answerCost: 0};
      for (let k = 0; k < count; k++) all = sum(all, await standingOf(k, scale));
      const isBest = !best || isBetter(all, best);
      const compared = {...all, scale, isBest};
      onCompared?.(compared);
      if (isBest) best = compared;
    } catch (error) {
      if (!best || signal?.aborted) throw error;
      onRefused?.(scale, error);
    }
    if (best && best.matched === best.visible) break;
  }
  return best?.scale ?? 1;
}
