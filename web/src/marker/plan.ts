/** The answer about a layout as a plan that people and programs read. Lengths in cm. */
import {minus, onPiece, plus, type Alignment, type Point} from '../model/geometry.js';
import {layNote, type LayNote} from '../model/lay-note.js';
import type {LaidPlacement, LayPlan, PhaseLength, WidthLength} from '../model/lay-plan.js';
import type {MarkerAnswer, MarkerLayout} from '../model/marker.js';
import {boxOf, signedArea} from '../model/polyline.js';
import {saidNote} from './draw/note-texts.js';
import type {MarkerOrder} from './problem.js';

/** Phases differ by less only by rounding. */
const samePhase = 1e-9;
/** Lengths that differ by less are the same to whoever buys cloth. */
const sameLength = 0.5;

/** As far as it is known while the rest is still looked into. */
type Layout = MarkerLayout & Partial<MarkerAnswer>;

const onCloth = (ring: readonly Point[], place: Alignment): readonly Point[] =>
  ring.map((p) => onPiece(place, p));

function placementsOf({problem, pieces}: MarkerOrder, {places}: Layout): readonly LaidPlacement[] {
  return pieces.flatMap((piece, k) => {
    const [place, asked] = [places[k], problem.pieces[k]];
    return place && asked ? [{...piece, ...place, cut: onCloth(asked.outline, place)}] : [];
  });
}

/** Cut from where the first piece begins, unless it is said where the print starts. */
function cutOff(placements: readonly LaidPlacement[], down: number): readonly LaidPlacement[] {
  const moved = (p: Point): Point => minus(p, [0, down]);
  return placements.map((one) => ({
    ...{...one, translation: moved(one.translation)},
    cut: one.cut.map(moved),
  }));
}

/** What the place of the print is worth. */
function phaseNotes(phases: readonly PhaseLength[]): readonly LayNote[] {
  const known = phases.flatMap(({lengthCm}) => lengthCm ?? []);
  const [least, most] = [Math.min(...known), Math.max(...known)];
  const nowhere = phases.length - known.length;
  return [
    ...(known.length > 1 && most - least > sameLength
      ? [layNote('phaseRange', {lengthsCm: [least, most]})]
      : []),
    ...(known.length > 0 && nowhere > 0
      ? [layNote('phaseNowhere', {counts: [nowhere, phases.length]})]
      : []),
  ];
}

/** What lies on a cloth lies on a wider one, too; what it takes on the cloth of the plan is the plan's length. */
function widthsOf(
  {problem: {widthCm: own, widthsCm}}: MarkerOrder,
  {widthLengthsCm}: Layout,
  lengthCm: number,
): readonly WidthLength[] {
  const known = [
    {widthCm: own, lengthCm},
    ...widthsCm.map((widthCm, k) => ({widthCm, lengthCm: widthLengthsCm?.[k] ?? Infinity})),
  ];
  return widthsCm.map((widthCm) => {
    const lengths = known.filter((other) => other.widthCm <= widthCm).map((one) => one.lengthCm);
    const least = widthCm === own ? lengthCm : Math.min(...lengths);
    return {widthCm, lengthCm: widthLengthsCm && least < Infinity ? least : null};
  });
}

/** @param layout the answer, or the best layout so far, of which it is not known yet how good it is */
export function layPlan(order: MarkerOrder, layout: Layout): LayPlan {
  const {problem, pieces, allowanceCm, notes} = order;
  const {widthCm, selvedgeCm, gapCm, ignoresPrint, wholeRepeats, startCm} = problem;
  const laid = placementsOf(order, layout);
  const {low, high} = boxOf(laid.flatMap(({cut}) => cut));
  const isWhole = laid.length > 0;
  // the search lays lines that are a hair larger than those that are cut
  const down = isWhole && startCm === undefined && !wholeRepeats ? low[1] : 0;
  const lengthCm = wholeRepeats || !isWhole ? layout.lengthCm : high[1] - down;
  const placements = down === 0 ? laid : cutOff(laid, down);
  const [x, y] = plus(layout.printOrigin, [0, -down]);
  const area = laid.reduce((sum, {cut}) => sum + signedArea(cut), 0);
  const {boundCm: bound = 0, freeLengthCm: free = null, proven = false} = layout;
  const phases = problem.phasesCm.map((phaseCm, k): PhaseLength => {
    const isThis = Math.abs(phaseCm - x) < samePhase;
    return {phaseCm, lengthCm: isThis ? lengthCm : (layout.phaseLengthsCm?.[k] ?? null)};
  });
  const details = [...notes, ...(ignoresPrint || !layout.phaseLengthsCm ? [] : phaseNotes(phases))];
  return {
    ...{format: 'seamwise-layplan/1', print: problem.print},
    ...{widthCm, selvedgeCm, gapCm, allowanceCm, lengthCm},
    printOrigin: ignoresPrint ? null : [x, y],
    placements,
    unplaced: pieces.filter((_, k) => !layout.places[k]),
    useShare: area / (widthCm * lengthCm),
    boundCm: proven ? lengthCm : Math.min(bound, lengthCm),
    proven,
    // where the print is no matter, a layout with it is one
    freeLengthCm: free === null ? null : Math.min(free, lengthCm),
    phases: ignoresPrint ? [] : phases,
    widths: widthsOf(order, layout, lengthCm),
    cheaper: [],
    notes: details.map((note) => saidNote(note)),
    noteDetails: details,
  };
}

/** The text of a plan's file. */
export const layPlanText = (plan: LayPlan): string => `${JSON.stringify(plan)}\n`;
