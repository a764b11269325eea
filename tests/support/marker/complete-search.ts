/**
 * The shortest layout of few pieces on printed fabric, by trying every place; checks plans that
 * claim to be proven. Lengths in cm.
 */
import {minus, plus, rotated, type Alignment, type Point} from '@/model/geometry/vectors.js';
import type {LayPlan} from '@/model/result/marker-plan.js';
import type {SolveResult} from '@/model/result/result.js';
import type {Repeat} from '@/model/print/wallpaper.js';
import {at} from '../plane.js';
import {allowedTurns, warpPeriod, type TurnRule} from './plan-print.js';
import {pieceOf, ringOnPiece, type PlanRules} from './plan-rules.js';
import {movedBy, outlineOf, ringDistance, sharedArea, type Outline} from './rings.js';

interface Board {
  readonly print: Repeat;
  readonly widthCm: number;
  readonly selvedgeCm: number;
  readonly gapCm: number;
  /** Distance of an origin of the print from the left edge. */
  readonly phaseCm: number;
}

interface BoardPiece {
  /** The cut line, in the piece's coordinates. */
  readonly ring: readonly Point[];
  readonly alignment: Alignment;
  readonly turns: TurnRule;
}

/** More pieces take too long. */
const mostPieces = 5;
/** Smaller overlaps count as none. [cm2] */
const leastShared = 1e-3;
/** Rounding error of summed coordinates. */
const rounding = 1e-6;

/** A piece in one of the print's turns, with the print's origin at the fabric's. */
interface Turned {
  readonly outline: Outline;
  readonly number: number;
}

/** A turned piece shifted by so many repeats. */
interface Dot {
  readonly turned: Turned;
  readonly i: number;
  readonly j: number;
  readonly by: Point;
  readonly lower: number;
  readonly upper: number;
}

/** Creates a test of two pieces at their places; results are cached by their difference. */
function compatibility({gapCm}: Board): (a: Dot, b: Dot) => boolean {
  const known = new Map<string, boolean>();
  const mayLie = (a: Dot, b: Dot): boolean => {
    const [one, other] = [a.turned.outline, b.turned.outline];
    const by = minus(b.by, a.by);
    // allows for rounding errors of pieces that keep the gap exactly
    const wanted = Math.max(rounding, gapCm - rounding);
    const apart = ringDistance(one, other, by, {most: wanted, enough: wanted - rounding / 10});
    if (apart >= wanted) return true;
    return gapCm === 0 && sharedArea(one.ring, movedBy(other.ring, by)) <= leastShared;
  };
  return (a, b) => {
    const [p, q] = a.turned.number <= b.turned.number ? [a, b] : [b, a];
    const key = `${p.turned.number},${q.turned.number},${q.i - p.i},${q.j - p.j}`;
    const before = known.get(key);
    if (before !== undefined) return before;
    const found = mayLie(p, q);
    known.set(key, found);
    return found;
  };
}

/** All places across the fabric whose lower end is in a window along it. */
function dotsOf(
  turned: Turned,
  {print: {w1, w2}, widthCm, selvedgeCm}: Board,
  [from, to]: Point,
): readonly Dot[] {
  const [left, lower, right, upper] = turned.outline.extent;
  const area = w1[0] * w2[1] - w1[1] * w2[0];
  // Whole repeats within the window, from its corners in steps of the print.
  const corners = [selvedgeCm - left, widthCm - selvedgeCm - right].flatMap((x) =>
    [from - lower, to - lower].map((y): Point => [
      (x * w2[1] - y * w2[0]) / area,
      (y * w1[0] - x * w1[1]) / area,
    ]),
  );
  const range = (axis: 0 | 1): number[] => {
    const steps = corners.map((corner) => corner[axis]);
    const first = Math.floor(Math.min(...steps));
    return Array.from({length: Math.ceil(Math.max(...steps)) - first + 1}, (_, k) => first + k);
  };
  return range(0)
    .flatMap((i) => range(1).map((j) => ({i, j})))
    .map(({i, j}): Dot => {
      const by = plus([i * w1[0], i * w1[1]], w2, j);
      return {turned, i, j, by, lower: lower + by[1], upper: upper + by[1]};
    })
    .filter(
      ({by, lower: foot}) =>
        left + by[0] >= selvedgeCm - rounding &&
        right + by[0] <= widthCm - selvedgeCm + rounding &&
        foot >= from - rounding &&
        foot < to + rounding,
    );
}

/**
 * The lowest end of a layout above a floor, if below `most`; branches on the piece with the fewest
 * places left.
 */
function lowestEnd(
  domains: readonly (readonly Dot[])[],
  mayLie: (a: Dot, b: Dot) => boolean,
  most: number,
): number {
  let best = most;
  const place = (open: readonly (readonly Dot[])[], end: number): void => {
    if (open.length === 0) {
      best = Math.min(best, end);
      return;
    }
    const isShort = ({upper}: Dot): boolean => upper < best - rounding;
    const left = open.map((dots) => dots.filter(isShort));
    const fewest = Math.min(...left.map(({length}) => length));
    if (fewest === 0) return;
    const next = left.findIndex(({length}) => length === fewest);
    for (const dot of at(left, next)) {
      if (!isShort(dot)) continue;
      const others = left.flatMap((dots, k) =>
        k === next ? [] : [dots.filter((other) => isShort(other) && mayLie(dot, other))],
      );
      if (others.every(({length}) => length > 0)) place(others, Math.max(end, dot.upper));
    }
  };
  place(domains, -Infinity);
  return best;
}

/**
 * The length of the shortest layout; undefined if there is none shorter than `most`.
 * @param most  for example the length of a known layout, which need not be found again
 * @throws {RangeError} for more than five pieces, and for a print without a repeat along the fabric
 */
export function shortestLength(
  pieces: readonly BoardPiece[],
  board: Board,
  most: number,
): number | undefined {
  if (pieces.length > mostPieces) throw new RangeError(`more than ${mostPieces} pieces`);
  const period = warpPeriod(board.print);
  if (period === undefined) throw new RangeError('the print has no repeat along the fabric');
  let number = 0;
  const turned = pieces.map(({ring, alignment, turns}) =>
    allowedTurns(board.print.group, turns).map((turn): Turned => {
      // maps the piece to the print, turned about its origin, and from there across the fabric
      const lie = (p: Point): Point =>
        plus(rotated(minus(p, alignment.translation), turn - alignment.angle), [board.phaseCm, 0]);
      return {outline: outlineOf(ring.map(lie)), number: number++};
    }),
  );
  const mayLie = compatibility(board);
  const all = turned.map((shapes) =>
    shapes.flatMap((shape) => dotsOf(shape, board, [0, period + most])),
  );
  const floors = all
    .flat()
    .map(({lower}) => lower)
    .filter((floor) => floor < period - rounding / 2)
    .sort((a, b) => a - b)
    .filter((floor, k, sorted) => k === 0 || floor - at(sorted, k - 1) > rounding);
  let best = most + 2 * rounding;
  for (const floor of floors) {
    const domains = all.map((dots) =>
      dots
        .filter(({lower, upper}) => lower >= floor - rounding && upper < floor + best)
        .sort((a, b) => a.upper - b.upper),
    );
    best = lowestEnd(domains, mayLie, floor + best) - floor;
  }
  return best <= most + rounding ? best : undefined;
}

/** The pieces of a plan and its fabric, for a separate search. */
export function boardOf(
  {placements, printOrigin, print, widthCm, selvedgeCm, gapCm}: LayPlan,
  results: readonly SolveResult[],
  {turns}: Pick<PlanRules, 'turns'>,
): {readonly pieces: readonly BoardPiece[]; readonly board: Board} {
  if (!printOrigin) throw new RangeError('the plan ignores the print');
  return {
    board: {print, widthCm, selvedgeCm, gapCm, phaseCm: printOrigin[0]},
    pieces: placements.map((placement) => {
      const piece = pieceOf(results, placement.result, placement.piece);
      if (!piece) throw new RangeError(`no piece ${placement.piece}`);
      const {alignment, name} = piece;
      return {ring: ringOnPiece(placement), alignment, turns: turns(name)};
    }),
  };
}
