/** Coordinates of the drawing of the fabric: units of a tenth of a millimetre, y downwards. */
import type {Point} from '../model/geometry/vectors.js';
import type {Units} from '../model/base/length-text.js';

/** Units per centimetre. */
export const unit = 100;

export interface SheetFrame {
  readonly widthCm: number;
  /** Length of the displayed fabric. */
  readonly lengthCm: number;
  /** [CSS px per cm] */
  readonly scale: number;
}

/** Margin around the fabric, for rulers. [CSS px] */
export const margin = {left: 46, right: 18, top: 14, bottom: 40} as const;

/** Converts CSS pixels to units of the drawing. */
export const pixels = (frame: SheetFrame, count: number): number => (count * unit) / frame.scale;

/** Size of the drawing. [CSS px] */
export const frameSize = ({widthCm, lengthCm, scale}: SheetFrame): Point => [
  widthCm * scale + margin.left + margin.right,
  lengthCm * scale + margin.top + margin.bottom,
];

export function viewBox(frame: SheetFrame): string {
  const [width, height] = frameSize(frame);
  const {left, top} = margin;
  return [-pixels(frame, left), -frame.lengthCm * unit - pixels(frame, top)]
    .concat(pixels(frame, width), pixels(frame, height))
    .map((one) => one.toFixed(1))
    .join(' ');
}

/** Converts coordinates of the fabric to the drawing. */
export const onSheet = ([x, y]: Point): Point => [x * unit, -y * unit];

/** Converts coordinates of the drawing to the fabric. [cm] */
export const offSheet = ({x, y}: {readonly x: number; readonly y: number}): Point => [
  x / unit,
  -y / unit,
];

/** Returns a closed line as path data. */
export const closed = (points: readonly Point[]): string =>
  `${points
    .map((p, k) => {
      const [x, y] = onSheet(p);
      return `${k === 0 ? 'M' : 'L'}${x.toFixed(1)} ${y.toFixed(1)}`;
    })
    .join('')}Z`;

/** Least distance between numbers on a ruler. [CSS px] */
const leastApart = 40;
const cmPerUnit: Readonly<Record<Units, number>> = {cm: 1, inch: 2.54};
const steps: readonly number[] = [1, 2, 5, 10, 20, 50, 100];

/** Returns the positions of a ruler's numbers, and of the lines between them. [cm] */
export function rulerMarks(
  lengthCm: number,
  scale: number,
  units: Units,
): readonly {readonly at: number; readonly label?: string}[] {
  const {[units]: cm} = cmPerUnit;
  const step = steps.find((one) => one * cm * scale >= leastApart) ?? 200;
  const half = (step * cm) / 2;
  return Array.from({length: Math.floor(lengthCm / half + 1e-6) + 1}, (_, k) => ({
    at: k * half,
    ...(k % 2 === 0 && {label: String((k / 2) * step)}),
  }));
}
