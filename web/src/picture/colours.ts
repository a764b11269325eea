/** The colours of a mismatch: green at 0, red from 2 cm on. Thickness and dashes say the same to eyes that do not part the two. */

/** From here on a mismatch is drawn as the worst. [cm] */
export const worstMismatch = 2;

const ramp = [
  [43, 147, 88],
  [226, 172, 51],
  [200, 48, 40],
] as const;

/** 0 for a perfect match, 1 for `worstMismatch` and beyond. */
export const severity = (mismatch: number): number =>
  Math.min(1, Math.max(0, mismatch / worstMismatch));

export function mismatchColour(mismatch: number): string {
  const at = severity(mismatch) * 2;
  const [low, high] = at < 1 ? [ramp[0], ramp[1]] : [ramp[1], ramp[2]];
  const share = at < 1 ? at : at - 1;
  const channel = (k: 0 | 1 | 2): string =>
    Math.round(low[k] + share * (high[k] - low[k]))
      .toString(16)
      .padStart(2, '0');
  return `#${channel(0)}${channel(1)}${channel(2)}`;
}

/** Width of the line along a seam. [px] */
export const mismatchWidth = (mismatch: number): number => 2.4 + 2.2 * severity(mismatch);

/** A match better than this part of the worst is a line without gaps. */
const solidBelow = 0.2;
/** Steps in which gaps grow, so that neighbouring edges share one rhythm. */
const gapSteps = 4;

/** Lengths of dash and gap before round caps: the worse, the wider the gaps. None where the print meets. [px] */
export function mismatchDash(mismatch: number): readonly [number, number] | undefined {
  const share = (severity(mismatch) - solidBelow) / (1 - solidBelow);
  if (share <= 0) return undefined;
  const step = Math.ceil(share * gapSteps);
  return [8, mismatchWidth(worstMismatch) + 1.5 * step];
}
