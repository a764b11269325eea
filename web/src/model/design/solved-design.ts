/**
 * The design of a result, from the files of its problem. A page needs it to open a result again.
 */
import {
  askingFor,
  noPicture,
  type Decisions,
  type DeliveredPrint,
  type DesignGarment,
  type Design,
} from './design.js';
import type {Point} from '../geometry/vectors.js';
import type {Print} from '../print/repeating-print.js';
import {repeatOf} from '../print/repeat.js';
import type {ResultPiece, ResultSymmetry, SolveResult} from '../result/result.js';
import type {Symmetry} from '../garment/symmetries.js';

export interface SolvedFiles {
  readonly garment: DesignGarment;
  readonly print: Print;
  /** The print before its fabric was considered, if it has `delivered`. */
  readonly stated?: DeliveredPrint['stated'];
  /** A `data:` URL with the image of one cell; without it the fabric is bare. */
  readonly picture: string | undefined;
  readonly options: Decisions['options'];
  readonly seed: number;
}

/**
 * Builds the design. It lists the symmetries of the result, so that detected ones become requested
 * ones.
 */
export function solvedDesign(
  {garment, print, stated, picture = noPicture, options, seed}: SolvedFiles,
  {pieces, symmetries, metrics}: SolveResult,
): Design {
  const {group, title = group, oneWay = false, cell = 'primitive', delivered} = print;
  const repeat = repeatOf(print);
  return {
    garment,
    print: {
      ...{title, group, ...repeat, oneWay, cell, image: picture},
      ...(delivered && {delivered: {...delivered, stated: stated ?? {group, cell, ...repeat}}}),
    },
    symmetry: askingFor(symmetries.map((one) => askedFor(one, pieces))),
    method: metrics.method,
    options,
    seed,
  };
}

function askedFor(symmetry: ResultSymmetry, pieces: readonly ResultPiece[]): Symmetry {
  const nameOf = (piece: number): string => pieces[piece]?.name ?? '';
  if (symmetry.kind === 'pair') {
    const [first, second] = symmetry.pieces;
    return {kind: 'pair', pieces: [nameOf(first), nameOf(second)]};
  }
  const {piece, map} = symmetry;
  // R F is the reflection in the line at angle / 2 from the y axis; p = 0 and its image are on
  // opposite sides of it
  const [x, y] = [map.translation[0] / 2, map.translation[1] / 2];
  const along = (distance: number): Point => {
    const across = x - distance * Math.sin(map.angle / 2);
    // the panel in the file shows its back, and the axis refers to the panel
    const inFile = pieces[piece]?.mirroredFromInput ? -across : across;
    return [inFile, y + distance * Math.cos(map.angle / 2)];
  };
  return {kind: 'piece', piece: nameOf(piece), axis: [along(-10), along(10)]};
}
