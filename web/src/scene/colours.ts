/** How a mismatch is drawn: by colour, and by width and gaps for eyes that do not part the colours. */

/** `absolute`: in steps at 1, 3 and 6 mm, for every print; `paper`: from 0 to 2 cm without steps, as in the paper. */
export type MismatchScale = 'absolute' | 'paper';

/** How the line along a seam is drawn. */
export interface MismatchLine {
  readonly colour: string;
  /** [px] */
  readonly width: number;
  /** Lengths of dash and gap before round caps. None where the print meets. [px] */
  readonly dash?: readonly [number, number];
}

/** Above each of these a mismatch is drawn as worse: it is seen from near, at once, from across the room. [cm] */
export const mismatchSteps = [0.1, 0.3, 0.6] as const;

/** From perfect to worst, as in `mismatchSteps`. */
export const stepLines: readonly MismatchLine[] = [
  {colour: '#2b9358', width: 2.4},
  {colour: '#b0b32f', width: 3, dash: [12, 5.5]},
  {colour: '#e88f24', width: 3.8, dash: [8, 7]},
  {colour: '#c83028', width: 4.6, dash: [6, 9]},
];

/** From here on a mismatch is drawn as the worst. [cm] */
export const worstMismatch: Readonly<Record<MismatchScale, number>> = {
  absolute: mismatchSteps[2],
  paper: 2,
};

/** 0 for a perfect match, 1 for the worst of the scale and beyond. */
export const severity = (mismatch: number, scale: MismatchScale): number =>
  Math.min(1, Math.max(0, mismatch / worstMismatch[scale]));

export function mismatchLine(mismatch: number, scale: MismatchScale = 'absolute'): MismatchLine {
  if (scale === 'paper') return rampLine(severity(mismatch, scale));
  const step = mismatchSteps.filter((bound) => mismatch > bound).length;
  return stepLines[step] ?? rampLine(1);
}

const ramp = [
  [43, 147, 88],
  [226, 172, 51],
  [200, 48, 40],
] as const;

/** On the scale of the paper a match better than this part of the worst is a line without gaps. */
const solidBelow = 0.2;
/** Steps in which its gaps grow, so that neighbouring edges share one rhythm. */
const gapSteps = 4;

/** @param share from 0, a perfect match, to 1 */
function rampLine(share: number): MismatchLine {
  const [low, high] = share < 0.5 ? [ramp[0], ramp[1]] : [ramp[1], ramp[2]];
  const part = share < 0.5 ? 2 * share : 2 * share - 1;
  const channel = (k: 0 | 1 | 2): string =>
    Math.round(low[k] + part * (high[k] - low[k]))
      .toString(16)
      .padStart(2, '0');
  const line = {colour: `#${channel(0)}${channel(1)}${channel(2)}`, width: 2.4 + 2.2 * share};
  const step = Math.ceil(((share - solidBelow) / (1 - solidBelow)) * gapSteps);
  return step > 0 ? {...line, dash: [8, 4.6 + 1.5 * step]} : line;
}
