/** Seams as a sewist counts them: the visible ones, and those of them that match. */
import type {SeamGroup, SeamState} from './result.js';

/** Least visibility of a seam that is seen at first sight. */
export const leastVisible = 1.5;

/** Greatest mismatch at which a print looks continuous. [cm] */
const seenMismatch = 0.3;

/** Share of a seam's length that decides its state. */
const mostOfIt = 0.95;

/** Weights of seams in the options, by number: the user's decision on how visible a seam is. */
export type SeamWeights = Readonly<Record<string, number>> | undefined;

/** A weight of the user replaces the visibility that follows from the place. */
export const visibilityOf = (
  {seams, visibility}: Pick<SeamGroup, 'seams' | 'visibility'>,
  weights: SeamWeights,
): number => Math.max(...seams.map((seam) => weights?.[seam] ?? visibility));

/** A gathered seam cannot match; nobody expects it to. */
const isGathers = ({state, reason}: Pick<SeamGroup, 'state' | 'reason'>): boolean =>
  state === 'cannot' && reason === 'gather';

export const isVisible = (group: SeamGroup, weights: SeamWeights): boolean =>
  !isGathers(group) && visibilityOf(group, weights) >= leastVisible;

/**
 * The seams that a headline counts: the visible ones without those that the user has left out. A
 * garment without visible seams counts its other seams.
 */
export function countedGroups(
  groups: readonly SeamGroup[],
  weights: SeamWeights,
): readonly SeamGroup[] {
  const open = groups.filter((group) => group.state !== 'choice' && !isGathers(group));
  const visible = open.filter((group) => isVisible(group, weights));
  return visible.length > 0 ? visible : open;
}

/** The seams that do not match, and that no headline counts, because they are hardly seen. */
export function quietSeams(
  groups: readonly SeamGroup[],
  weights: SeamWeights,
): ReadonlySet<number> {
  const counted = new Set(countedGroups(groups, weights));
  const quiet = groups.filter((group) => !counted.has(group) && group.state !== 'matches');
  return new Set(quiet.flatMap(({seams}) => seams));
}

/** Numbers of counted seams, and of those that match. */
export interface SeamCount {
  readonly matched: number;
  readonly counted: number;
}

export function seamCount(groups: readonly SeamGroup[], weights: SeamWeights): SeamCount {
  const counted = countedGroups(groups, weights);
  const matched = counted.filter(({state}) => state === 'matches').length;
  return {matched, counted: counted.length};
}

/** Lengths and mismatches of the edges along a seam. [cm] */
interface AlongSeam {
  readonly lengths: readonly number[];
  readonly mismatch: readonly number[];
}

/**
 * The mismatch of a seam in one figure: 95 % of the length of `seams` have at most this mismatch.
 * [cm]
 */
export function mismatchAlong(seams: readonly AlongSeam[]): number {
  const edges = seams
    .flatMap(({lengths, mismatch}) => lengths.map((length, k) => ({length, off: mismatch[k] ?? 0})))
    .sort((one, other) => one.off - other.off);
  let left = mostOfIt * edges.reduce((sum, {length}) => sum + length, 0) - 1e-9;
  return edges.find(({length}) => (left -= length) <= 0)?.off ?? 0;
}

/** The state that follows from the mismatch of a seam alone. @param off as of `mismatchAlong` */
export const stateAt = (off: number): SeamState =>
  off <= seenMismatch ? 'matches' : off <= 2 * seenMismatch ? 'close' : 'off';
