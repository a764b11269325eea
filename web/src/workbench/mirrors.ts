/** Symmetries of the garment that are kept or found. */
import type {Registration, Symmetry} from '../model/garment/symmetries.js';
import type {Solving} from './solving.js';

/** A symmetry by names of pieces, with its map: p' = R F p + t of the face-up pieces. */
export type Mirror = Symmetry & Pick<Registration, 'map'>;

/** The symmetries that the result keeps, and the other detected ones. */
export function mirrorsOf({pattern, found}: Pick<Solving, 'pattern' | 'found'>): readonly Mirror[] {
  const nameOf = (piece: number): string => pattern?.pieces[piece]?.name ?? '';
  const kept = (pattern?.symmetries ?? []).map((one): Mirror =>
    one.kind === 'piece'
      ? {kind: 'piece', piece: nameOf(one.piece), map: one.map}
      : {kind: 'pair', pieces: [nameOf(one.pieces[0]), nameOf(one.pieces[1])], map: one.map},
  );
  return [...kept, ...found];
}
