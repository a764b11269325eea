/**
 * The visible lines and words of a page, from the operator list of pdf.js. Lengths in mm, from the
 * lower left corner of the page as it is shown, y up.
 */
import type {Box} from '../../../model/geometry/polyline.js';
import type {Point} from '../../../model/geometry/vectors.js';

/** The style of a line. Lines of one style share the object. */
export interface InkStyle {
  /** Colour as `#rrggbb`; undefined without a stroke. */
  readonly stroke?: string;
  readonly isFilled: boolean;
  readonly widthMm: number;
  /** Lengths of dashes and gaps; empty for solid lines. */
  readonly dashMm: readonly number[];
  /** From 0 to 1. */
  readonly opacity: number;
  /** Name of the innermost layer. */
  readonly layer?: string;
}

export interface InkLine {
  readonly points: readonly Point[];
  readonly isClosed: boolean;
  readonly style: InkStyle;
}

export interface InkText {
  readonly text: string;
  /** Both ends of the baseline. */
  readonly from: Point;
  readonly to: Point;
  /** Letter height. */
  readonly size: number;
  readonly layer?: string;
}

export interface PageInk {
  /** Page number, from 1. */
  readonly number: number;
  readonly width: number;
  readonly height: number;
  /** The part of the page to which most lines are clipped. */
  readonly window: Box;
  readonly lines: readonly InkLine[];
  readonly texts: readonly InkText[];
  /** True if the page has filled marks that are not read, since the file has too many. */
  readonly hasMoreMarks?: true;
}

/** The number of letters on a page. */
export const lettersOn = ({texts}: PageInk): number =>
  texts.reduce((sum, {text}) => sum + text.replaceAll(/\s/g, '').length, 0);

/** Returns whether a page shows neither lines nor letters. */
export const isBare = (page: PageInk): boolean => page.lines.length === 0 && lettersOn(page) === 0;

/** The middle of a text. */
export const middleOf = ({from, to}: InkText): Point => [
  (from[0] + to[0]) / 2,
  (from[1] + to[1]) / 2,
];
