/** Places of a size's pieces over those of a larger size, for files of several sizes. */
import {
  middle,
  minus,
  plus,
  rotated,
  type Alignment,
  type Point,
} from '../model/geometry/vectors.js';
import {boxOf} from '../model/geometry/polyline.js';
import type {CutPiece} from './cut-piece.js';
import type {CutSheet} from './cut-sheet.js';

/** The least shift that moves an interval into [0, length]. */
const shiftInto = (low: number, high: number, length: number): number =>
  Math.max(-low, Math.min(0, length - high));

/**
 * Places each piece with its middle on that of the piece of its name, within the sheet.
 * @throws {RangeError} if the sheet has no piece of a name
 */
export function nestedPlaces(cuts: readonly CutPiece[], under: CutSheet): readonly Alignment[] {
  return cuts.map(({name, label, cut}) => {
    const below = under.pieces.find((piece) => piece.name === name);
    if (!below) {
      throw new RangeError(
        `size ${under.size ?? 'of the other result'} has no piece ${label}; all sizes of a file have the same pieces.`,
      );
    }
    const {angle} = below.place;
    const own = boxOf((cut[0] ?? []).map((p) => rotated(p, angle)));
    const around = boxOf(below.cut[0] ?? []);
    const shift = minus(middle(around.low, around.high), middle(own.low, own.high));
    const [low, high] = [plus(own.low, shift), plus(own.high, shift)];
    const inside: Point = [
      shiftInto(low[0], high[0], under.widthCm),
      shiftInto(low[1], high[1], under.heightCm),
    ];
    return {angle, translation: plus(shift, inside)};
  });
}
