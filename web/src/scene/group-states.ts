/** Groups of seams of any result, and their states before the match. */
import type {SeamGroup, SolveResult} from '../model/result/result.js';
import {
  countedGroups,
  mismatchAlong,
  stateAt,
  type SeamCount,
  type SeamWeights,
} from '../model/result/seam-groups.js';
import {finalMismatch, type SeamMismatch} from './mismatch.js';

/** The mismatch of a group's counted seams; 0 if none counts, since those always match. [cm] */
export const groupMismatch = (
  {seams}: Pick<SeamGroup, 'seams'>,
  mismatch: readonly SeamMismatch[],
): number =>
  mismatchAlong(
    seams.flatMap((seam) => mismatch.slice(seam, seam + 1)).filter(({counts}) => counts),
  );

/**
 * The groups of a result. A result of an earlier version has none: each of its seams counts as a
 * visible one, with the state that its mismatch implies.
 */
export function seamGroupsOf(result: SolveResult): readonly SeamGroup[] {
  if (result.seamGroups) return result.seamGroups;
  const {seams: mismatch} = finalMismatch(result);
  return result.seams.map(({matched, why}, seam): SeamGroup => {
    const state = matched ? stateAt(groupMismatch({seams: [seam]}, mismatch)) : 'choice';
    const isOff = why && (state === 'close' || state === 'off');
    return {seams: [seam], place: 'other', visibility: 1.5, state, ...(isOff && {reason: why})};
  });
}

/** Counts the same seams as for the result, with another mismatch. */
export function countAt(
  groups: readonly SeamGroup[],
  weights: SeamWeights,
  mismatch: readonly SeamMismatch[],
): SeamCount {
  const counted = countedGroups(groups, weights);
  const matched = counted.filter((group) => stateAt(groupMismatch(group, mismatch)) === 'matches');
  return {matched: matched.length, counted: counted.length};
}
