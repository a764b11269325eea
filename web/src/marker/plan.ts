/** Converts the solver's answer to a layout for people and programs. Lengths in cm. */
import {minus, onPiece, plus, type Alignment, type Point} from '../model/geometry/vectors.js';
import {layNote, type LayNote} from '../model/result/lay-note.js';
import type {
  LaidPlacement,
  LayPlan,
  PhaseLength,
  WidthLength,
} from '../model/result/marker-plan.js';
import type {MarkerAnswer, MarkerLayout} from '../model/result/marker-search.js';
import {boxOf, signedArea} from '../model/geometry/polyline.js';
import {saidNote} from './draw/note-texts.js';
import {garmentShares} from './garment-shares.js';
import type {MarkerOrder} from './problem.js';

/** Phases that differ by less differ only by rounding. [cm] */
const samePhase = 1e-9;
/** Lengths that differ by less are equal to a buyer. [cm] */
const sameLength = 0.5;

/** The known part of an answer during the search. */
type Layout = MarkerLayout & Partial<MarkerAnswer>;

const onFabric = (ring: readonly Point[], place: Alignment): readonly Point[] =>
  ring.map((p) => onPiece(place, p));

function placementsOf({problem, pieces}: MarkerOrder, {places}: Layout): readonly LaidPlacement[] {
  return pieces.flatMap((piece, k) => {
    const [place, asked] = [places[k], problem.pieces[k]];
    return place && asked ? [{...piece, ...place, cut: onFabric(asked.outline, place)}] : [];
  });
}

/** Moves the layout to the start of its first piece, for fabric that may be cut anywhere. */
function cutOff(placements: readonly LaidPlacement[], down: number): readonly LaidPlacement[] {
  const moved = (p: Point): Point => minus(p, [0, down]);
  return placements.map((one) => ({
    ...{...one, translation: moved(one.translation)},
    cut: one.cut.map(moved),
  }));
}

/** Notes on the effect of the print's position. */
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

/**
 * Lengths for other widths. A layout for a narrower fabric also fits a wider one; the layout's own
 * width has its own length.
 */
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

/**
 * The layout of an order.
 * @param layout the final answer, or the best layout so far without figures of its quality
 */
export function layPlan(order: MarkerOrder, layout: Layout): LayPlan {
  const {problem, pieces, allowanceCm, hemCm, notes} = order;
  const {widthCm, selvedgeCm, gapCm, ignoresPrint, wholeRepeats, startCm} = problem;
  const laid = placementsOf(order, layout);
  const {low, high} = boxOf(laid.flatMap(({cut}) => cut));
  const isWhole = laid.length > 0;
  // the search lays lines that are slightly larger than the cut lines
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
    ...{widthCm, selvedgeCm, gapCm, allowanceCm, hemCm, lengthCm},
    printOrigin: ignoresPrint ? null : [x, y],
    placements,
    unplaced: pieces.filter((_, k) => !layout.places[k]),
    useShare: area / (widthCm * lengthCm),
    boundCm: proven ? lengthCm : Math.min(bound, lengthCm),
    proven,
    // without the print, a layout with the print is valid too
    freeLengthCm: free === null ? null : Math.min(free, lengthCm),
    phases: ignoresPrint ? [] : phases,
    widths: widthsOf(order, layout, lengthCm),
    cheaper: [],
    notes: details.map((note) => saidNote(note)),
    noteDetails: details,
  };
}

/** The text of a layout's file. */
export const layPlanText = (plan: LayPlan): string =>
  `${JSON.stringify({...plan, garments: garmentShares(plan)})}\n`;
