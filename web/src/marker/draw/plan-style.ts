/** Sizes and small marks of a drawn layout, all in proportion to one size. */
import type {CutLayer, CutLine, CutText} from '../../cutting/cut-sheet.js';
import type {Point} from '../../model/geometry/vectors.js';

/** Millimetres on the fabric per millimetre on paper, for lines, letters and distances. */
export type Size = number;

/**
 * The size of a layout at 1 : scale. At true scale it is larger, since people read it from farther
 * away.
 */
export const sizeAt = (scale: number): Size => (scale === 1 ? 2.5 : scale);

/** Converts millimetres on paper to centimetres on the fabric, or on a sheet at its scale. */
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

/**
 * A text mark.
 * @param mm letter height on paper
 */
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
