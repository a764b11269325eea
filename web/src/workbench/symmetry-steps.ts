/** Steps that add and remove symmetries. A piece takes part in one symmetry at most. */
import {askingFor, type Decisions, type Design} from '../model/design/design.js';
import {carries} from '../model/print/repeat.js';
import type {DetectedSymmetry, Symmetry} from '../model/garment/symmetries.js';

const piecesOf = (symmetry: Symmetry): readonly string[] =>
  symmetry.kind === 'piece' ? [symmetry.piece] : symmetry.pieces;

/** Returns whether two symmetries concern the same piece or the same two pieces. */
export const concernsSame = (a: Symmetry, b: Symmetry): boolean =>
  a.kind === b.kind && piecesOf(a).every((name) => piecesOf(b).includes(name));

/** Returns whether both can hold: a piece is either symmetric in itself or one of a pair. */
const compatible = (a: Symmetry, b: Symmetry): boolean =>
  !piecesOf(a).some((name) => piecesOf(b).includes(name));

/** Adds a symmetry and removes those that are incompatible with it. */
export const withSymmetry = (
  kept: readonly Symmetry[],
  symmetry: Symmetry,
): Pick<Decisions, 'symmetry'> => ({
  symmetry: [...kept.filter((other) => compatible(symmetry, other)), symmetry],
});

export const withoutSymmetry = (
  kept: readonly Symmetry[],
  symmetry: Symmetry,
): Pick<Decisions, 'symmetry'> => ({
  symmetry: askingFor(kept.filter((other) => other !== symmetry)),
});

/** A detected symmetry without the data about its accuracy. */
export const asked = (found: DetectedSymmetry): Symmetry =>
  found.kind === 'pair'
    ? {kind: 'pair', pieces: found.pieces}
    : {
        kind: 'piece',
        piece: found.piece,
        ...(found.axis && {axis: found.axis}),
        ...(found.seams && {seams: found.seams}),
      };

/** Adds all detected symmetries that are compatible with the kept ones and with the print. */
export function withAll(
  kept: readonly Symmetry[],
  group: Design['print']['group'],
  found: readonly DetectedSymmetry[],
): readonly Symmetry[] {
  let symmetries = kept;
  for (const one of found) {
    if (carries(group, one.kind) && symmetries.every((other) => compatible(one, other)))
      symmetries = [...symmetries, asked(one)];
  }
  return symmetries;
}
