/** Walks from seam to seam in the order of their mismatch. */
import {worstSeams, type SeamRow} from '../lists/rows.js';

interface Rank {
  /** 1 for the worst seam. */
  readonly rank: number;
  readonly count: number;
}

/** Returns undefined for a seam that does not count. */
export function rankOf(rows: readonly SeamRow[], seam: number): Rank | undefined {
  const worst = worstSeams(rows);
  const at = worst.findIndex((row) => row.seam === seam);
  return at < 0 ? undefined : {rank: at + 1, count: worst.length};
}

/** Returns the seam with the next smaller (1) or larger (-1) mismatch; wraps around at the ends. */
export function nextWorst(
  rows: readonly SeamRow[],
  seam: number | undefined,
  step: 1 | -1,
): number | undefined {
  const worst = worstSeams(rows);
  const at = worst.findIndex((row) => row.seam === seam);
  const next = at < 0 ? (step > 0 ? 0 : -1) : (at + step) % worst.length;
  return worst.at(next)?.seam;
}
