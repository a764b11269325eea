/** What would take less cloth: offered, never done unasked. Lengths in cm. */
import {combined, onPiece, onPrint, type Point} from '../model/geometry.js';
import type {CheaperLay, LayPlan} from '../model/lay-plan.js';
import type {MarkerAnswer, MarkerHooks} from '../model/marker.js';
import {signedArea} from '../model/polyline.js';
import {printDistance, type Repeat} from '../model/wallpaper.js';
import {cheaperDesign, type SolveDesign} from './designs.js';
import type {MarkerGarment} from './pieces.js';
import {markerOrder, type LaidPrint, type MarkerOrder} from './problem.js';
import type {MarkerSettings} from './settings.js';
import {hasShiftsToTry, layShifted, unlessFailed, type Lay} from './shifted.js';

/** Each is looked at for so long, as a share of the time for the plan. */
const effortShare = 0.25;
/** Whoever buys cloth does not care for less. */
const leastSaving = 1;
/** A piece that is smaller than this share of the largest may be left unmatched without being noticed much. */
const smallShare = 0.25;
/** As many of them, the largest, are tried at so many places along each vector of the repeat. */
const mostUnmatched = 2;
const steps = 3;
/** A piece lies on its print that misses it by less. */
const onIt = 1e-3;

/** What the questions are answered with. */
export interface CheaperMeans {
  readonly lay: Lay;
  /** Without it no other design is looked at. */
  readonly solve?: SolveDesign;
}

interface Laid {
  readonly garments: readonly MarkerGarment[];
  readonly settings: MarkerSettings;
  readonly print: LaidPrint | undefined;
  readonly plan: LayPlan;
}

/** Shifts over the whole cell of the repeat. */
const anyShifts = ({w1, w2}: Repeat): readonly Point[] =>
  Array.from({length: steps * steps - 1}, (_, k) =>
    combined([w1, w2], ((k + 1) % steps) / steps, Math.floor((k + 1) / steps) / steps),
  );

/** Wherever the print starts at the left edge. */
const withoutPhase = (settings: MarkerSettings): MarkerSettings => ({
  widthCm: settings.widthCm,
  ...Object.fromEntries(Object.entries(settings).filter(([name]) => name !== 'phaseCm')),
});

/** Names of the pieces that do not lie on the print as the seams ask for. */
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

/** The order with some small pieces free to lie on any part of the print; none where all are large. */
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

/** The shortest first. @param lay seeks the layout of a problem */
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

/** A plan that tells of them: but for another design's, each is also a layout without regard to the print. */
export function withOffers(plan: LayPlan, cheaper: readonly CheaperLay[]): LayPlan {
  const same = cheaper.filter(({kind}) => kind !== 'design').map(({lengthCm}) => lengthCm);
  const {freeLengthCm: free} = plan;
  return {...plan, cheaper, freeLengthCm: free === null ? null : Math.min(free, ...same)};
}

/** With the print moved under loose pieces and under joined ones; undefined where there are none, or no place. */
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
