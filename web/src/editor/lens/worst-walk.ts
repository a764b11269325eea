/** The way from seam to seam by how much they miss. */
import {worstSeams, type SeamRow} from '../lists/rows.js';

interface Rank {
  /** From 1, the worst. */
  readonly rank: number;
  readonly count: number;
}

/** Undefined for a seam that does not count. */
export function rankOf(rows: readonly SeamRow[], seam: number): Rank | undefined {
  const worst = worstSeams(rows);
  const at = worst.findIndex((row) => row.seam === seam);
  return at < 0 ? undefined : {rank: at + 1, count: worst.length};
}

/** The seam that misses next less (1) or next more (-1); round from the last to the first. */
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
