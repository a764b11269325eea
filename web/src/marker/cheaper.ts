/** What would take less cloth and costs no seam its print: offered, never done unasked. Lengths in cm. */
import {combined, onPiece, onPrint, type Point} from '../model/geometry.js';
import type {CheaperLay, LayPlan} from '../model/lay-plan.js';
import type {MarkerAnswer, MarkerHooks, MarkerProblem} from '../model/marker.js';
import {signedArea} from '../model/polyline.js';
import {printDistance, type Repeat} from '../model/wallpaper.js';
import type {MarkerGarment} from './pieces.js';
import {markerOrder, type LaidPrint, type MarkerOrder} from './problem.js';
import type {MarkerSettings} from './settings.js';

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

type Lay = (problem: MarkerProblem, hooks: MarkerHooks) => Promise<MarkerAnswer>;

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
  lay: Lay,
  hooks: Pick<MarkerHooks, 'signal'> = {},
): Promise<readonly CheaperLay[]> {
  const {printOrigin, lengthCm: length} = plan;
  const {effort = 1, phaseCm, shift = 'kept', ignoresPrint = false, fold = false} = settings;
  if (!printOrigin || ignoresPrint || fold || effort === 0 || plan.unplaced.length > 0) return [];
  const anywhere = Object.fromEntries(
    Object.entries(settings).filter(([name]) => name !== 'phaseCm'),
  ) as unknown as MarkerSettings;
  const quick = {effort: effort * effortShare, widthsCm: []};
  const orderFor = (changed: MarkerSettings): MarkerOrder => {
    const order = markerOrder(garments, {...changed, ...quick}, print);
    return {...order, problem: {...order.problem, alsoFree: false}};
  };
  const here = {...settings, phaseCm: printOrigin[0]};
  const tried: (() => Promise<CheaperLay | undefined>)[] = [];
  const tries = (
    order: MarkerOrder | undefined,
    told: (answer: MarkerAnswer) => CheaperLay,
  ): void => {
    if (!order) return;
    tried.push(async () => {
      // on such cloth, it may be that some piece finds no place
      const answer = await lay(order.problem, hooks).catch((error: unknown) => {
        hooks.signal?.throwIfAborted();
        if (error instanceof Error) return undefined;
        throw error;
      });
      return answer && answer.lengthCm < length - leastSaving ? told(answer) : undefined;
    });
  };
  if (phaseCm !== undefined) {
    tries(orderFor(anywhere), ({lengthCm, printOrigin: [x]}) => ({
      ...{kind: 'phase', lengthCm, phaseCm: x},
    }));
  }
  if (shift === 'kept') {
    const order = orderFor({...here, shift: 'component'});
    const isLoose = order.problem.pieces.some(({shifts}) => shifts.length > 0);
    tries(isLoose ? order : undefined, (answer) => ({
      ...{kind: 'shift', lengthCm: answer.lengthCm, pieces: moved(order, answer)},
    }));
  }
  const unmatched = withSmallUnmatched(orderFor(here));
  tries(unmatched, (answer) => ({
    kind: 'unmatched',
    lengthCm: answer.lengthCm,
    pieces: unmatched ? moved(unmatched, answer) : [],
  }));
  const offers: CheaperLay[] = [];
  for (const offer of tried) offers.push(...[await offer()].filter((one) => one !== undefined));
  return offers.sort((one, other) => one.lengthCm - other.lengthCm);
}
