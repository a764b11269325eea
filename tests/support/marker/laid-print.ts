/** Checks the print under the pieces of a layout, and their grain and nap. */
import {minus, onPiece, onPrint, towards, type Point} from '@/model/geometry/vectors.js';
import type {LayPlan} from '@/model/result/marker-plan.js';
import type {SolveResult} from '@/model/result/result.js';
import type {Repeat} from '@/model/print/wallpaper.js';
import {at} from '../plane.js';
import {lessRepeats, offNormaliser, offRule, onFabric} from './plan-print.js';
import {nameOf, pieceOf, type PlanRules} from './plan-rules.js';

/** Tolerance for print points, and for lengths that are sums of coordinates. [cm] */
const exact = 1e-6;
/** Smallest significant turn. [rad] */
const leastTurn = 1e-7;
/** A piece whose grain runs nearly across the fabric has no upside: the sine of its deviation. */
const leastUpright = 0.2;

/** Three points of a piece, far from each other. */
function farPoints(shape: readonly Point[]): readonly [Point, Point, Point] {
  const furthest = (others: readonly Point[]): Point => {
    const off = (p: Point): number => Math.min(...others.map((q) => Math.hypot(...minus(p, q))));
    return shape.reduce((best, p) => (off(p) > off(best) ? p : best));
  };
  const first = furthest([at(shape, 0)]);
  const second = furthest([first]);
  return [first, second, furthest([first, second])];
}

/**
 * Checks that the fabric shows the print of each piece's alignment, up to one turn and whole
 * repeats.
 */
export function checkPrint(
  {print, printOrigin: origin, placements}: LayPlan,
  results: readonly SolveResult[],
  {shift: rule = 'kept'}: PlanRules,
): string[] {
  if (!origin) return [];
  const found = placements.map((placement) => {
    const piece = pieceOf(results, placement.result, placement.piece);
    if (!piece) throw new RangeError(`no piece ${placement.piece}`);
    const {shape, alignment} = piece;
    const points = farPoints(shape);
    return onFabric(
      print,
      points.map((p) => onPrint(alignment, p)),
      points.map((p) => minus(onPiece(placement, p), origin)),
    );
  });
  return placements.flatMap((placement, k) => {
    const {off, shift} = at(found, k);
    const name = nameOf(placement);
    if (off > exact) return [`${name}: the print is turned, ${off} cm off`];
    const length = Math.hypot(...shift);
    if (rule === 'kept') {
      return length > exact ? [`${name}: the print is ${length} cm off`] : [];
    }
    const moved = offNormaliser(print, shift);
    if (moved > exact) return [`${name}: its print moved to other symmetries by ${moved} cm`];
    const joined = componentOf(at(results, placement.result));
    return placements.slice(0, k).flatMap((other, n) => {
      const isJoined =
        other.result === placement.result &&
        other.copy === placement.copy &&
        joined(other.piece) === joined(placement.piece);
      const apart = Math.hypot(...lessRepeats(print, minus(shift, at(found, n).shift)));
      return isJoined && apart > exact
        ? [`${name}: the print moved ${apart} cm against ${other.piece}`]
        : [];
    });
  });
}

/** Numbers the pieces; those connected by matched seams and lines get the same number. */
function componentOf({pieces, seams, matches = []}: SolveResult): (name: string) => number {
  const number = pieces.map((_, k) => k);
  const pairs = [...seams.filter(({matched}) => matched), ...matches];
  for (const {a, b} of pairs) {
    const [one, other] = [at(number, a.piece), at(number, b.piece)];
    number.forEach((n, k) => {
      if (n === other) number[k] = one;
    });
  }
  return (name) =>
    at(
      number,
      pieces.findIndex((piece) => piece.name === name),
    );
}

/** Checks that the grain has a permitted angle, and the nap one direction where required. */
export function checkTurns(
  {placements}: LayPlan,
  results: readonly SolveResult[],
  {turns, nap = 'none'}: PlanRules,
): string[] {
  const up = placements.map(({result, piece, angle}) => {
    const {grainAngle = Math.PI / 2} = pieceOf(results, result, piece) ?? {};
    const rise = towards(grainAngle + angle)[1];
    return Math.abs(rise) < leastUpright ? 0 : Math.sign(rise);
  });
  return placements.flatMap((placement, k) => {
    const {result, copy, piece, angle} = placement;
    const {alignment} = pieceOf(results, result, piece) ?? {};
    const off = offRule(turns(piece), angle + (alignment?.angle ?? 0));
    const broken = off > leastTurn ? [`${nameOf(placement)}: its grain is off by ${off} rad`] : [];
    const before = placements.findIndex(
      (other, n) =>
        n < k &&
        (nap === 'one-way' ||
          (nap === 'garment' && other.result === result && other.copy === copy)) &&
        at(up, n) * at(up, k) < 0,
    );
    if (before >= 0) {
      broken.push(`${nameOf(placement)}: its nap runs against ${nameOf(at(placements, before))}`);
    }
    return broken;
  });
}

/** Checks that the plan has the best phase, and that its print is at this phase. */
export function checkPhases({print, printOrigin: origin, phases, lengthCm}: LayPlan): string[] {
  if (!origin) return [];
  const isHere = phases.some(
    ({phaseCm, lengthCm: length}) =>
      length !== null &&
      Math.abs(length - lengthCm) <= exact &&
      isAcross(print, origin[0] - phaseCm),
  );
  const shorter = phases.filter(({lengthCm: length}) => (length ?? Infinity) < lengthCm - exact);
  return [
    ...(isHere ? [] : [`no phase has its print at ${origin[0]} cm and its length`]),
    ...shorter.map(({phaseCm, lengthCm: length}) => `${phaseCm} cm takes ${length} cm, less`),
  ];
}

/** Returns whether some combination of repeats has this component across the fabric. */
function isAcross({w1, w2}: Repeat, across: number): boolean {
  const steps = Array.from({length: 121}, (_, k) => k - 60);
  return steps.some((i) => steps.some((j) => Math.abs(i * w1[0] + j * w2[0] - across) <= exact));
}
