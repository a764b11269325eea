/** Sizes of what is drawn of a lay plan, and small marks: everything in parts of one size. */
import type {CutLayer, CutLine, CutText} from '../../cutting/cut-sheet.js';
import type {Point} from '../../model/geometry.js';

/** Millimetres on the cloth for one on paper: of lines, letters and distances. */
export type Size = number;

/** Of a plan at 1 : scale; at true scale it is read from farther away. */
export const sizeAt = (scale: number): Size => (scale === 1 ? 2.5 : scale);

/** Centimetres on the cloth, or on a sheet at its scale, for millimetres on paper. */
export const cm = (size: Size, mm: number): number => (size * mm) / 10;

interface LineStyle {
  /** [mm on paper] */
  readonly width: number;
  readonly dash?: readonly number[];
  readonly halo?: number;
  readonly isFaint?: boolean;
  readonly isClosed?: boolean;
  readonly layer?: CutLayer;
}

export const lineOf = (
  size: Size,
  points: readonly Point[],
  {width, dash, halo, isFaint, isClosed = false, layer = 'marks'}: LineStyle,
): CutLine => ({
  ...{kind: 'line', layer, points, isClosed, widthMm: size * width},
  ...(dash && {dashMm: dash.map((part) => size * part)}),
  ...(halo !== undefined && {haloMm: size * halo}),
  ...(isFaint && {isFaint}),
});

/** @param mm height of its letters on paper */
export const textOf = (
  size: Size,
  at: Point,
  words: string | readonly string[],
  mm: number,
  style: Partial<Pick<CutText, 'layer' | 'hasPlate' | 'angle' | 'align' | 'weight'>> = {},
): CutText => ({
  ...{kind: 'text', layer: 'words', at, sizeMm: size * mm, hasPlate: false},
  lines: typeof words === 'string' ? [words] : words,
  ...(typeof words === 'string' && {weight: 'regular'}),
  ...style,
});
