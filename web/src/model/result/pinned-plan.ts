/**
 * Length of fabric that pins cost, separate from the length that the print costs. Lengths in cm.
 */
import type {LayPlan} from './marker-plan.js';

/**
 * Adds the figures of the unpinned pieces to a plan with pins.
 * @param before the plan in which pieces were pinned; undefined if its fabric was different
 */
export function aroundPins(plan: LayPlan, before: LayPlan | undefined): LayPlan {
  // pins do not apply to fabric of another width
  if (!before) return {...plan, widths: [], unpinnedLengthCm: null};
  const {lengthCm, unpinnedLengthCm = lengthCm, freeLengthCm, widths} = before;
  return {...plan, widths, unpinnedLengthCm, freeLengthCm: freeLengthCm ?? plan.freeLengthCm};
}

/** Each cost is undefined if it is unknown, or if nothing is pinned. */
interface LayCosts {
  readonly printCm?: number;
  readonly pinsCm?: number;
  /** Cost of print and pins together, where they cannot be separated. */
  readonly bothCm?: number;
}

/**
 * Compares plans in pairs that differ in one respect only: without pins, with and without the
 * print; and on the print, with and without pins.
 */
export function layCosts({
  lengthCm,
  freeLengthCm,
  unpinnedLengthCm: unpinned,
  unplaced,
}: LayPlan): LayCosts {
  if (unplaced.length > 0) return {};
  if (unpinned === null) return freeLengthCm === null ? {} : {bothCm: lengthCm - freeLengthCm};
  // pins may give a shorter layout than the search did, which then was not the shortest
  const least = Math.min(lengthCm, unpinned ?? lengthCm);
  return {
    ...(freeLengthCm !== null && {printCm: Math.max(0, least - freeLengthCm)}),
    ...(unpinned !== undefined && {pinsCm: lengthCm - least}),
  };
}
