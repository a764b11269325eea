/**
 * The print moved under all pieces of a component at once, by shifts after which it meets itself at every seam as
 * before: which of them take less cloth. Lengths in cm, angles in radians.
 */
import {minus, rotated, type Point} from '../model/geometry.js';
import type {MarkerAnswer, MarkerHooks, MarkerProblem} from '../model/marker.js';
import {signedArea} from '../model/polyline.js';
import {leastExtents} from './extents.js';
import type {MarkerOrder} from './problem.js';
import {movesFreely, spreadShifts} from './repeats.js';

/** Seeks the layout of a problem. */
export type Lay = (problem: MarkerProblem, hooks: MarkerHooks) => Promise<MarkerAnswer>;

/** By how much the print is moved under the pieces of each component of an order. */
type ComponentShifts = readonly Point[];

/** Each layout that is tried takes so long, as a share of the time for the plan. */
const effortShare = 0.05;
/** As many are tried, with the same effort as the plan in all. */
const mostTried = 20;
/** Of one component where shifts run on, however few components there are. */
const mostOfOne = 12;
/** Lengths that differ by less are the same. */
const sameLength = 0.05;

/** The order with the print moved. */
function shiftedOrder(order: MarkerOrder, shifts: ComponentShifts): MarkerOrder {
  const pieces = [...order.problem.pieces];
  for (const [c, group] of order.components.entries()) {
    const by = shifts[c] ?? [0, 0];
    for (const k of group) {
      const piece = pieces[k];
      if (!piece) continue;
      const {angle, translation} = piece.alignment;
      // W(p) + v = R^T (p - (t - R v))
      const moved = minus(translation, rotated(by, angle));
      pieces[k] = {...piece, alignment: {angle, translation: moved}};
    }
  }
  return {...order, problem: {...order.problem, pieces}};
}

/** Quickly, and of nothing but the length, where the print lies as in a layout. */
const hastened = (problem: MarkerProblem, origin: Point, effort: number): MarkerProblem => ({
  ...problem,
  ...{phasesCm: [origin[0]], widthsCm: [], alsoFree: false, effort},
});

/**
 * Components whose print may move. Where the cloth may be cut anywhere and nobody says where the print starts, all of
 * them moved alike is another place of the print, and those are tried already: then the first one stays.
 */
function movableIn({components, problem}: MarkerOrder): readonly number[] {
  const isOpen = problem.phasesCm.length > 1 && problem.startCm === undefined;
  return [...components.keys()].slice(isOpen ? 1 : 0);
}

/** Whether there is anything to be tried. */
export const hasShiftsToTry = (order: MarkerOrder): boolean =>
  movableIn(order).length > 0 && spreadShifts(order.problem.print, 1).length > 0;

/** Of any places of its print: the area of all pieces, or the tallest piece, whichever asks for more. */
export function plainBound(problem: MarkerProblem): number {
  const {widthCm, selvedgeCm, pieces} = problem;
  const area = pieces.reduce((sum, {outline}) => sum + signedArea(outline), 0);
  const heights = pieces.map((piece) => leastExtents(piece, problem)[1]);
  return Math.max(area / (widthCm - 2 * selvedgeCm), ...heights);
}

/** What is known of a layout where the print might have been moved otherwise: no proof looks into that. */
const withoutProof = ({problem}: MarkerOrder, answer: MarkerAnswer): MarkerAnswer => ({
  ...answer,
  ...{boundCm: Math.min(answer.boundCm, plainBound(problem)), proven: false},
});

/** Whether a layout's bound holds whatever the print is moved by. */
const isBoundOfAll = ({problem}: MarkerOrder): boolean =>
  problem.pieces.every(({shifts}) => shifts.length === 0) || !movesFreely(problem.print);

interface Shifted {
  /** The order whose answer it is. */
  readonly order: MarkerOrder;
  readonly answer: MarkerAnswer;
}

const none: Point = [0, 0];
/** All components are gone through as often at most, while that helps. */
const rounds = 2;

/**
 * Moves the print under one component after the other, each time to where it takes least.
 * @param lengthFor how much cloth it takes so
 * @param tells hears of each layout that is tried
 */
async function bestShifts(
  order: MarkerOrder,
  lengthFor: (by: ComponentShifts) => Promise<number>,
  tells: (tried: number) => void,
): Promise<ComponentShifts> {
  const movable = movableIn(order);
  const each = Math.min(mostOfOne, Math.max(1, Math.floor(mostTried / movable.length)));
  const shifts = spreadShifts(order.problem.print, each);
  let best: ComponentShifts = order.components.map(() => none);
  let length = await lengthFor(best);
  let tried = 0;
  for (let round = 0; round < rounds; round++) {
    const before = best;
    for (const c of movable.slice(0, mostTried)) {
      const {[c]: own} = best;
      for (const by of round === 0 ? shifts : [none, ...shifts]) {
        if (by === own) continue;
        tells(tried++);
        const next = best.map((one, k) => (k === c ? by : one));
        const found = await lengthFor(next);
        if (found < length - sameLength) [best, length] = [next, found];
      }
    }
    if (best === before) break;
  }
  return best;
}

/**
 * A layout where the print is moved under components to where quick layouts are shortest, then once more as thorough
 * as the first layout was.
 * @param laid the answer with the print as it is
 * @returns the shorter one of the two
 */
export async function layShifted(
  order: MarkerOrder,
  laid: MarkerAnswer,
  lay: Lay,
  {signal, onProgress}: Pick<MarkerHooks, 'signal' | 'onProgress'> = {},
): Promise<Shifted> {
  const {effort} = order.problem;
  if (effort === 0 || !hasShiftsToTry(order)) {
    return {order, answer: isBoundOfAll(order) ? laid : withoutProof(order, laid)};
  }
  const stays = {order, answer: withoutProof(order, laid)};
  const laidBy = (by: ComponentShifts, share: number): Promise<MarkerAnswer | undefined> => {
    const {problem} = shiftedOrder(order, by);
    const asked = hastened(problem, laid.printOrigin, effort * share);
    return unlessFailed(lay(asked, signal ? {signal} : {}), signal);
  };
  const best = await bestShifts(
    order,
    async (by) => (await laidBy(by, effortShare))?.lengthCm ?? Infinity,
    (tried) => onProgress?.({stage: 'shifts', fraction: Math.min(1, tried / (rounds * mostTried))}),
  );
  if (best.every((by) => by === none)) return stays;
  const found = await laidBy(best, 1);
  if (!found || found.lengthCm >= laid.lengthCm - sameLength) return stays;
  const {freeLengthCm, phaseLengthsCm, widthLengthsCm} = laid;
  const answer = {...found, freeLengthCm, phaseLengthsCm, widthLengthsCm};
  return {order: shiftedOrder(order, best), answer: withoutProof(order, answer)};
}

/** Undefined for what cannot be, as where some piece finds no place. @throws what ends the search */
export async function unlessFailed<T>(
  tried: Promise<T>,
  signal: AbortSignal | undefined,
): Promise<T | undefined> {
  return tried.catch((error: unknown) => {
    signal?.throwIfAborted();
    if (error instanceof Error) return undefined;
    throw error;
  });
}
