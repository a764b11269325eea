/** Pieces that are cut larger than sewn, because their fabric shrinks in the wash. */
import {mappedFold} from '../model/garment/folds.js';
import {unit, type Point} from '../model/geometry/vectors.js';
import {cutAlignment, cutMap, shrinks} from '../model/print/as-cut.js';
import type {Delivered} from '../model/print/repeating-print.js';
import type {CutPiece} from './cut-piece.js';

/** The piece before the wash, with all of its marks; unchanged for fabric that does not shrink. */
export function largerPiece(piece: CutPiece, delivered: Delivered | undefined): CutPiece {
  if (!shrinks(delivered)) return piece;
  const of = cutMap(piece.alignment, delivered);
  const line = (points: readonly Point[]): readonly Point[] => points.map(of);
  const pair = ([from, to]: readonly [Point, Point]): readonly [Point, Point] => [of(from), of(to)];
  const {stripe, plaid} = piece;
  return {
    ...piece,
    alignment: cutAlignment(piece.alignment, delivered),
    sewn: piece.sewn.map(line),
    cut: piece.cut.map(line),
    corners: line(piece.corners),
    notches: piece.notches.map((notch) => ({
      ...notch,
      ...{at: of(notch.at), outward: unit(of(notch.outward))},
    })),
    grain: pair(piece.grain),
    letters: piece.letters.map((letter) => ({...letter, at: of(letter.at)})),
    matches: line(piece.matches),
    ticks: piece.ticks.map((tick) => ({
      ...tick,
      ...{at: of(tick.at), along: unit(of(tick.along))},
    })),
    ...(stripe && {stripe: pair(stripe)}),
    ...(plaid && {plaid: pair(plaid)}),
    internalLines: piece.internalLines.map(line),
    folds: piece.folds.map((fold) => mappedFold(fold, of)),
    drillHoles: line(piece.drillHoles),
    words: {...piece.words, at: of(piece.words.at)},
  };
}
