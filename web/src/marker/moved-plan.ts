/** A plan with its pieces lying otherwise: as somebody has moved them. Lengths in cm. */
import {onPiece, type Alignment} from '../model/geometry.js';
import {isOfPhases} from '../model/lay-note.js';
import type {LaidPlacement, LayPlan} from '../model/lay-plan.js';
import {boxOf, signedArea} from '../model/polyline.js';
import {saidNote} from './draw/note-texts.js';
import type {MarkerOrder} from './problem.js';

/** A length that is greater than the bound by less is as short as it can be. */
const sameLength = 0.05;
/** Of lengths, which are sums. [cm] */
const rounding = 1e-6;

type Pieces = Pick<MarkerOrder, 'pieces'> & {
  readonly problem: Pick<MarkerOrder['problem'], 'pieces'>;
};

/** What a plan says of where each piece lies; undefined where it has no place. */
export function placesIn({pieces}: Pieces, {placements}: LayPlan): (Alignment | undefined)[] {
  return pieces.map(({result, copy, piece, nth}) => {
    const found = placements.find(
      (one) => one.result === result && one.copy === copy && one.piece === piece && one.nth === nth,
    );
    return found && {angle: found.angle, translation: found.translation};
  });
}

/** Whether pieces lie otherwise than a plan says. @param places by number of the pieces */
export const isMoved = (
  order: Pieces,
  plan: LayPlan,
  places: readonly (Alignment | undefined)[],
): boolean => JSON.stringify(placesIn(order, plan)) !== JSON.stringify(places);

/** What is said of the same pieces packed otherwise is no part of a plan whose pieces were moved. */
function unpacked(plan: LayPlan, lengthCm: number | null): Partial<LayPlan> {
  const {printOrigin} = plan;
  const noteDetails = plan.noteDetails.filter((note) => !isOfPhases(note));
  return {
    phases: printOrigin ? [{phaseCm: printOrigin[0], lengthCm}] : [],
    ...{widths: [], cheaper: []},
    ...{noteDetails, notes: noteDetails.map((note) => saidNote(note))},
  };
}

/** The plan as its pieces lie, of which all figures hold. @param places by number of the pieces */
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
  // what is known of all pieces says nothing of some of them
  const boundCm = unplaced.length > 0 ? 0 : Math.min(plan.boundCm, lengthCm);
  const area = placements.reduce((sum, {cut}) => sum + signedArea(cut), 0);
  const wholeCm = unplaced.length > 0 ? null : lengthCm;
  return {
    ...plan,
    ...(isMoved({pieces, problem}, plan, places) && unpacked(plan, wholeCm)),
    // on other widths nothing is pinned
    ...(plan.unpinnedLengthCm !== undefined && {widths: []}),
    // what it costs that it was moved is no cost of the print
    freeLengthCm: Math.abs(lengthCm - plan.lengthCm) < rounding ? plan.freeLengthCm : null,
    ...{placements, lengthCm, boundCm, useShare: area / (plan.widthCm * lengthCm || 1)},
    proven: unplaced.length === 0 && plan.proven && lengthCm - boundCm < sameLength,
    unplaced,
  };
}
