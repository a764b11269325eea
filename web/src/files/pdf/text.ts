/** Lines of text in page content. */
import {scoped, through} from './content.js';
import {towards, type Point} from '../../model/geometry/vectors.js';
import {widthOf, type Weight} from './fonts/letters.js';
import type {PdfResources} from './resources.js';

export {widthOf, type Weight} from './fonts/letters.js';

interface TextStyle {
  readonly size: number;
  readonly weight?: Weight;
  readonly align?: 'left' | 'middle' | 'right';
  /** Counter-clockwise. [rad] */
  readonly angle?: number;
}

const shares = {left: 0, middle: 0.5, right: 1};

/** A line of text with its baseline at a point. */
export function textAt(
  {fonts}: PdfResources,
  at: Point,
  text: string,
  {size, weight = 'regular', align = 'left', angle = 0}: TextStyle,
): string {
  const [c, s] = towards(angle);
  const back = shares[align] * size * widthOf(text, weight);
  const shift: Point = [at[0] - c * back, at[1] - s * back];
  return scoped(through({xx: c, xy: -s, yx: s, yy: c, shift}), fonts.shown(text, size, weight));
}
