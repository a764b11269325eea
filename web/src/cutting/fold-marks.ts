/** Pleats, tucks and creases on the cutting sheet. Lengths in cm. */
import type {DraftedFold} from '../model/garment/garment-document.js';
import {hidesFabric, mappedFold} from '../model/garment/folds.js';
import {distance, middle, type Point} from '../model/geometry/vectors.js';
import {formatLength, type Units} from '../model/base/length-text.js';
import {sheetTextsIn} from '../texts/sheet-texts.js';

/** A fold of a piece, in coordinates of its shape. */
export interface CutFold extends Pick<DraftedFold, 'kind' | 'line' | 'to'> {
  /** Such as "Inverted pleat, 20 cm", with the width of the fabric between the lines. */
  readonly name: string;
}

/** Units and locale of lengths. */
export interface LengthStyle {
  readonly units: Units;
  readonly locale: string;
}

const middleOf = ([from, to]: readonly [Point, Point]): Point => middle(from, to);

/** A fold of the garment on a solved piece; its lines stay straight. */
export function cutFold(
  drafted: DraftedFold,
  onShape: (p: Point) => Point,
  {units, locale}: LengthStyle,
): CutFold {
  const {kind, line, to} = mappedFold(drafted, onShape);
  const width = to && hidesFabric(drafted) ? distance(middleOf(line), middleOf(to)) : 0;
  const name = sheetTextsIn(locale).foldKinds[kind];
  return {
    ...{kind, line},
    ...(to && {to}),
    name: width > 0 ? `${name}, ${formatLength(width, units, locale)}` : name,
  };
}
