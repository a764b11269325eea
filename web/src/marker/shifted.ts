/**
 * Moves the print under all pieces of a component at once, by shifts that keep the match at every
 * seam, to save fabric. Lengths in cm, angles in radians.
 */
import {minus, rotated, type Point} from '../model/geometry/vectors.js';
import type {MarkerAnswer, MarkerHooks, MarkerProblem} from '../model/result/marker-search.js';
import {signedArea} from '../model/geometry/polyline.js';
import {leastExtents} from './places.js';
import type {MarkerOrder} from './problem.js';
import {movesFreely, spreadShifts} from './repeats.js';

/** Computes the layout of a problem. */
export type Lay = (problem: MarkerProblem, hooks: MarkerHooks) => Promise<MarkerAnswer>;

/** Shift of the print under each component of an order. */
type ComponentShifts = readonly Point[];

/** Effort of each trial layout, as a share of the layout's. */
const effortShare = 0.05;
/** Number of trial layouts, which in total take the same effort as the layout. */
const mostTried = 20;
/**
 * Greatest number of shifts per component if shifts are continuous, for any number of components.
 */
const mostOfOne = 12;
/** Lengths that differ by less are equal. [cm] */
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

/** A quick problem that computes only the length, with the print placed as in a given layout. */
const hastened = (problem: MarkerProblem, origin: Point, effort: number): MarkerProblem => ({
  ...problem,
  ...{phasesCm: [origin[0]], widthsCm: [], alsoFree: false, effort},
});

/**
 * Indices of components whose print may move. If both the cut and the print's start are open,
 * moving all components alike only moves the print, which the phases already try. The first
 * component then stays.
 */
function movableIn({components, problem}: MarkerOrder): readonly number[] {
  const isOpen = problem.phasesCm.length > 1 && problem.startCm === undefined;
  return [...components.keys()].slice(isOpen ? 1 : 0);
}

/** Returns whether there are shifts to try. */
export const hasShiftsToTry = (order: MarkerOrder): boolean =>
  movableIn(order).length > 0 && spreadShifts(order.problem.print, 1).length > 0;

/**
 * A lower bound of the length for any position of the print: the larger of the pieces' area per
 * width and the tallest piece.
 */
export function plainBound(problem: MarkerProblem): number {
  const {widthCm, selvedgeCm, pieces} = problem;
  const area = pieces.reduce((sum, {outline}) => sum + signedArea(outline), 0);
  const heights = pieces.map((piece) => leastExtents(piece, problem)[1]);
  return Math.max(area / (widthCm - 2 * selvedgeCm), ...heights);
}

/** The answer with its proof removed, since the proof does not cover other shifts of the print. */
const withoutProof = ({problem}: MarkerOrder, answer: MarkerAnswer): MarkerAnswer => ({
  ...answer,
  ...{boundCm: Math.min(answer.boundCm, plainBound(problem)), proven: false},
});

/** Returns whether a layout's bound holds for all shifts of the print. */
const isBoundOfAll = ({problem}: MarkerOrder): boolean =>
  problem.pieces.every(({shifts}) => shifts.length === 0) || !movesFreely(problem.print);

interface Shifted {
  /** The order that the answer belongs to. */
  readonly order: MarkerOrder;
  readonly answer: MarkerAnswer;
}

const none: Point = [0, 0];
/** Greatest number of passes over all components; a pass without improvement is the last. */
const rounds = 2;

/**
 * Moves the print under one component after another, each time to the shift of least length.
 * @param lengthFor returns the length for given shifts
 * @param tells called before each trial layout
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
 * Computes a layout with the print moved to the shifts of the shortest trial layouts, with the
 * effort of the first layout.
 * @param laid the answer without shifts
 * @returns the shorter of the two layouts
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

/**
 * The value, or undefined if it failed, as for a piece without a place.
 * @throws the reason of an aborted search
 */
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
