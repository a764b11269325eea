/**
 * Suggestions that save fabric. They are offered and never applied automatically. Lengths in cm.
 */
import type {MarkerGarment} from '../model/design/marker-garment.js';
import {combined, onPiece, onPrint, type Point} from '../model/geometry/vectors.js';
import type {CheaperLay, LayPlan} from '../model/result/marker-plan.js';
import type {MarkerAnswer, MarkerHooks} from '../model/result/marker-search.js';
import {signedArea} from '../model/geometry/polyline.js';
import {printDistance, type Repeat} from '../model/print/wallpaper.js';
import {cheaperDesign, type SolveDesign} from './designs.js';
import {markerOrder, type LaidPrint, type MarkerOrder} from './problem.js';
import type {MarkerSettings} from './settings.js';
import {hasShiftsToTry, layShifted, unlessFailed, type Lay} from './shifted.js';

/** Search time of each suggestion, as a share of the layout's. */
const effortShare = 0.25;
/** Smallest saving worth a suggestion. [cm] */
const leastSaving = 1;
/** Pieces smaller than this share of the largest may stay unmatched: it is hardly noticed. */
const smallShare = 0.25;
/** Number of small pieces, largest first, that are freed; and positions tried per repeat vector. */
const mostUnmatched = 2;
const steps = 3;
/** A piece is in register with the print if it is off by less than this. [cm] */
const onIt = 1e-3;

/** Functions that compute the suggestions. */
export interface CheaperMeans {
  readonly lay: Lay;
  /** Other designs are considered only with this function. */
  readonly solve?: SolveDesign;
}

interface Laid {
  readonly garments: readonly MarkerGarment[];
  readonly settings: MarkerSettings;
  readonly print: LaidPrint | undefined;
  readonly plan: LayPlan;
}

/** Shifts that cover the whole cell of the repeat. */
const anyShifts = ({w1, w2}: Repeat): readonly Point[] =>
  Array.from({length: steps * steps - 1}, (_, k) =>
    combined([w1, w2], ((k + 1) % steps) / steps, Math.floor((k + 1) / steps) / steps),
  );

/** Settings that leave the print's start at the left edge open. */
const withoutPhase = (settings: MarkerSettings): MarkerSettings => ({
  widthCm: settings.widthCm,
  ...Object.fromEntries(Object.entries(settings).filter(([name]) => name !== 'phaseCm')),
});

/** Names of the pieces whose place does not match the print of their alignment. */
function moved({problem, pieces}: MarkerOrder, {places, printOrigin}: MarkerAnswer): string[] {
  const away = printDistance(problem.print);
  return problem.pieces.flatMap(({outline, alignment}, k) => {
    const [place, piece] = [places[k], pieces[k]];
    if (!place || !piece) return [];
    const misses = outline.slice(0, 3).some((p) => {
      const [x, y] = onPiece(place, p);
      return away([x - printOrigin[0], y - printOrigin[1]], onPrint(alignment, p)) > onIt;
    });
    return misses ? [piece.piece] : [];
  });
}

/** The order with some small pieces free of the print; undefined if no piece is small. */
function withSmallUnmatched(order: MarkerOrder): MarkerOrder | undefined {
  const {problem} = order;
  const areas = problem.pieces.map(({outline}) => Math.abs(signedArea(outline)));
  const most = smallShare * Math.max(...areas);
  const small = [...areas.keys()]
    .filter((k) => (areas[k] ?? 0) < most)
    .sort((one, other) => (areas[other] ?? 0) - (areas[one] ?? 0))
    .slice(0, mostUnmatched);
  if (small.length === 0) return undefined;
  const shifts = anyShifts(problem.print);
  const pieces = problem.pieces.map((piece, k) => (small.includes(k) ? {...piece, shifts} : piece));
  return {...order, problem: {...problem, pieces}};
}

/**
 * Suggestions for a layout, the shortest first.
 * @param lay computes the layout of a problem
 */
export async function cheaperLays(
  {garments, settings, print, plan}: Laid,
  {lay, solve}: CheaperMeans,
  hooks: Pick<MarkerHooks, 'signal'> = {},
): Promise<readonly CheaperLay[]> {
  const {printOrigin, lengthCm: length} = plan;
  const {effort = 1, phaseCm, shift = 'kept', ignoresPrint = false, fold = false} = settings;
  if (!printOrigin || ignoresPrint || fold || effort === 0 || plan.unplaced.length > 0) return [];
  const quick = (share: number) => ({effort: effort * share, widthsCm: []});
  const orderOf = (
    laid: readonly MarkerGarment[],
    changed: MarkerSettings,
    share = effortShare,
  ): MarkerOrder => {
    const order = markerOrder(laid, {...changed, ...quick(share)}, print);
    return {...order, problem: {...order.problem, alsoFree: false}};
  };
  const here = {...settings, phaseCm: printOrigin[0]};
  const {signal} = hooks;
  const isWorthIt = (answer: MarkerAnswer | undefined): answer is MarkerAnswer =>
    answer !== undefined && answer.lengthCm < length - leastSaving;
  const laid = (order: MarkerOrder) => unlessFailed(lay(order.problem, hooks), signal);

  const offers: CheaperLay[] = [];
  if (phaseCm !== undefined) {
    const answer = await laid(orderOf(garments, withoutPhase(settings)));
    if (isWorthIt(answer)) {
      const {lengthCm, printOrigin: origin} = answer;
      offers.push({kind: 'phase', lengthCm, phaseCm: origin[0]});
    }
  }
  if (shift === 'kept') {
    const order = orderOf(garments, {...settings, shift: 'component'});
    const answer = await shiftedAnswer(order, here.phaseCm, {lay}, hooks);
    if (isWorthIt(answer)) {
      const {lengthCm} = answer;
      offers.push({kind: 'shift', lengthCm, pieces: moved(order, answer)});
    }
  }
  const unmatched = withSmallUnmatched(orderOf(garments, here));
  const answer = unmatched && (await laid(unmatched));
  if (unmatched && isWorthIt(answer)) {
    const {lengthCm} = answer;
    offers.push({kind: 'unmatched', lengthCm, pieces: moved(unmatched, answer)});
  }
  const design =
    solve &&
    (await cheaperDesign(
      {
        ...{garments, lengthCm: length, leastSaving, share: effortShare, lay, solve},
        orderOf: (changed, share) => orderOf(changed, settings, share),
      },
      hooks,
    ));
  if (design) offers.push(design);
  return offers.sort((one, other) => one.lengthCm - other.lengthCm);
}

/**
 * Adds suggestions to a layout. Except for another design's, each is also a layout without the
 * print.
 */
export function withOffers(plan: LayPlan, cheaper: readonly CheaperLay[]): LayPlan {
  const same = cheaper.filter(({kind}) => kind !== 'design').map(({lengthCm}) => lengthCm);
  const {freeLengthCm: free} = plan;
  return {...plan, cheaper, freeLengthCm: free === null ? null : Math.min(free, ...same)};
}

/**
 * A layout with the print moved under loose pieces and under components; undefined if there is
 * nothing to move or no place.
 */
async function shiftedAnswer(
  order: MarkerOrder,
  phaseCm: number,
  {lay}: Pick<CheaperMeans, 'lay'>,
  hooks: Pick<MarkerHooks, 'signal'>,
): Promise<MarkerAnswer | undefined> {
  const isLoose = order.problem.pieces.some(({shifts}) => shifts.length > 0);
  if (!isLoose && !hasShiftsToTry(order)) return undefined;
  const problem = {...order.problem, phasesCm: [phaseCm]};
  const first = await unlessFailed(lay(problem, hooks), hooks.signal);
  return first && (await layShifted(order, first, lay, hooks)).answer;
}
