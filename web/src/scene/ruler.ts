/** Ticks along a length of fabric. */

interface Ruler {
  /** Distance between two ticks. [cm] */
  readonly step: number;
  /** Positions from the start of the strip. [CSS px] */
  readonly ticks: readonly number[];
}

const metric = [0.5, 1, 2, 5, 10, 20];
const inches = [0.25, 0.5, 1, 2, 4, 8].map((inch) => inch * 2.54);
/** Least distance between ticks. [CSS px] */
const closest = 7;

/**
 * @param from start of the seam on the strip [CSS px]
 * @param length length of the seam on the strip [CSS px]
 * @param scale [CSS px per cm]
 */
export function rulerOf(from: number, length: number, scale: number, units: 'cm' | 'inch'): Ruler {
  const steps = units === 'inch' ? inches : metric;
  const step = steps.find((one) => one * scale >= closest) ?? steps.at(-1) ?? 1;
  const count = Math.floor(length / (step * scale) + 1e-9);
  return {step, ticks: Array.from({length: count + 1}, (_, k) => from + k * step * scale)};
}
