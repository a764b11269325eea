/** The one size of the print in which several garments match best together. */
import {isBetter, together, type Standing} from '../../model/result/visible-seams.js';

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
      const standings: Standing[] = [];
      for (let k = 0; k < count; k++) standings.push(await standingOf(k, scale));
      const all = together(standings);
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
