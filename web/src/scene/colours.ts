/**
 * Line styles for a mismatch: by colour, and by width and gaps for people who do not distinguish
 * the colours.
 */

/**
 * `absolute`: steps at 1, 3 and 6 mm for every print; `paper`: continuous from 0 to 2 cm, as in the
 * paper.
 */
export type MismatchScale = 'absolute' | 'paper';

/** Style of a line along a seam. */
export interface MismatchLine {
  readonly colour: string;
  /** [px] */
  readonly width: number;
  /** Lengths of dash and gap without the round caps; undefined if the print matches. [px] */
  readonly dash?: readonly [number, number];
}

/**
 * Upper bounds of the steps of mismatch: visible from near, at once, and from across a room. [cm]
 */
export const mismatchSteps = [0.1, 0.3, 0.6] as const;

/** Line styles from perfect to worst, divided by `mismatchSteps`. */
export const stepLines: readonly MismatchLine[] = [
  {colour: '#2b9358', width: 2.4},
  {colour: '#b0b32f', width: 3, dash: [12, 5.5]},
  {colour: '#e88f24', width: 3.8, dash: [8, 7]},
  {colour: '#c83028', width: 4.6, dash: [6, 9]},
];

/** Least mismatch with the worst style. [cm] */
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

/** Share of the worst mismatch below which lines have no gaps, on the scale of the paper. */
const solidBelow = 0.2;
/** Number of gap sizes, so that neighbouring edges have the same dashes. */
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
