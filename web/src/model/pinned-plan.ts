/** What pieces that somebody has pinned cost in cloth, apart from what the print costs. Lengths in cm. */
import type {LayPlan} from './lay-plan.js';

/** A plan around pinned pieces, with what is known of the same pieces, none of them pinned. @param before the plan that was pinned in; undefined where its cloth was another */
export function aroundPins(plan: LayPlan, before: LayPlan | undefined): LayPlan {
  // nothing is pinned on cloth of another width
  if (!before) return {...plan, widths: [], unpinnedLengthCm: null};
  const {lengthCm, unpinnedLengthCm = lengthCm, freeLengthCm, widths} = before;
  return {...plan, widths, unpinnedLengthCm, freeLengthCm: freeLengthCm ?? plan.freeLengthCm};
}

/** Each undefined where it is not known, or nothing is pinned. */
interface LayCosts {
  readonly printCm?: number;
  readonly pinsCm?: number;
  /** Of print and pins together, where the two cannot be told apart. */
  readonly bothCm?: number;
}

/** Like is compared with like: what is laid without pins, with the print and without it; and what is laid on the print, with pins and without. */
export function layCosts({
  lengthCm,
  freeLengthCm,
  unpinnedLengthCm: unpinned,
  unplaced,
}: LayPlan): LayCosts {
  if (unplaced.length > 0) return {};
  if (unpinned === null) return freeLengthCm === null ? {} : {bothCm: lengthCm - freeLengthCm};
  // where pins happen to lie better than all that was found, that was not the shortest
  const least = Math.min(lengthCm, unpinned ?? lengthCm);
  return {
    ...(freeLengthCm !== null && {printCm: Math.max(0, least - freeLengthCm)}),
    ...(unpinned !== undefined && {pinsCm: lengthCm - least}),
  };
}
