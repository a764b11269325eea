/** Updates a layout whose pieces were moved by hand. Lengths in cm. */
import {onPiece, type Alignment} from '../model/geometry/vectors.js';
import {isOfPhases} from '../model/result/lay-note.js';
import type {LaidPlacement, LayPlan} from '../model/result/marker-plan.js';
import {boxOf, signedArea} from '../model/geometry/polyline.js';
import {saidNote} from './draw/note-texts.js';
import type {MarkerOrder} from './problem.js';

/** A layout is shortest if its length exceeds the bound by less than this. */
const sameLength = 0.05;
/** Rounding error of summed lengths. [cm] */
const rounding = 1e-6;

type Pieces = Pick<MarkerOrder, 'pieces'> & {
  readonly problem: Pick<MarkerOrder['problem'], 'pieces'>;
};

/** The place of each piece in a layout; undefined for an unplaced piece. */
export function placesIn({pieces}: Pieces, {placements}: LayPlan): (Alignment | undefined)[] {
  return pieces.map(({result, copy, piece, nth}) => {
    const found = placements.find(
      (one) => one.result === result && one.copy === copy && one.piece === piece && one.nth === nth,
    );
    return found && {angle: found.angle, translation: found.translation};
  });
}

/**
 * Returns whether pieces have other places than in a layout.
 * @param places by piece index
 */
export const isMoved = (
  order: Pieces,
  plan: LayPlan,
  places: readonly (Alignment | undefined)[],
): boolean => JSON.stringify(placesIn(order, plan)) !== JSON.stringify(places);

/** Changes to a moved layout: statements about the computed packing no longer apply. */
function unpacked(plan: LayPlan, lengthCm: number | null): Partial<LayPlan> {
  const {printOrigin} = plan;
  const noteDetails = plan.noteDetails.filter((note) => !isOfPhases(note));
  return {
    phases: printOrigin ? [{phaseCm: printOrigin[0], lengthCm}] : [],
    ...{widths: [], cheaper: []},
    ...{noteDetails, notes: noteDetails.map((note) => saidNote(note))},
  };
}

/**
 * The layout with new places and updated figures.
 * @param places by piece index
 */
export function movedPlan(
  {pieces, problem}: Pieces,
  plan: LayPlan,
  places: readonly (Alignment | undefined)[],
): LayPlan {
  const placements = pieces.flatMap((piece, k): LaidPlacement[] => {
    const [place, asked] = [places[k], problem.pieces[k]];
    return place && asked
      ? [{...piece, ...place, cut: asked.outline.map((p) => onPiece(place, p))}]
      : [];
  });
  const unplaced = pieces.filter((_, k) => !places[k]);
  const lengthCm = Math.max(0, boxOf(placements.flatMap(({cut}) => cut)).high[1]);
  // the bound for all pieces does not hold for some of them
  const boundCm = unplaced.length > 0 ? 0 : Math.min(plan.boundCm, lengthCm);
  const area = placements.reduce((sum, {cut}) => sum + signedArea(cut), 0);
  const wholeCm = unplaced.length > 0 ? null : lengthCm;
  return {
    ...plan,
    ...(isMoved({pieces, problem}, plan, places) && unpacked(plan, wholeCm)),
    // the lengths for other widths ignore pins
    ...(plan.unpinnedLengthCm !== undefined && {widths: []}),
    // fabric lost by moving pieces is not a cost of the print
    freeLengthCm: Math.abs(lengthCm - plan.lengthCm) < rounding ? plan.freeLengthCm : null,
    ...{placements, lengthCm, boundCm, useShare: area / (plan.widthCm * lengthCm || 1)},
    proven: unplaced.length === 0 && plan.proven && lengthCm - boundCm < sameLength,
    unplaced,
  };
}
