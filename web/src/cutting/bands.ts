/** The allowance along an edge, between sewn line and cut line. Lengths in cm. */
import {cross, dot, minus, plus, turnBetween, unit, type Point} from '../model/geometry/vectors.js';
import {outOf} from './corners.js';

export interface Band {
  /** Counter-clockwise polygons that cover the allowance. */
  readonly cloth: readonly (readonly Point[])[];
  /** The cut line from the edge's start to its end. */
  readonly cut: readonly Point[];
}

/** A segment of the edge. */
interface Step {
  readonly from: Point;
  readonly to: Point;
  readonly out: Point;
}

/** Greatest total turn of a band as one polygon; beyond it, the cut line may cross itself. [rad] */
const greatestTurn = 2.2;
/** Segments with a smaller 1 + cosine of their turn form a corner. */
const leastBend = 0.6;

/** Points of the cut line at a point of the edge: one, or two at a corner. */
function feet(
  at: Point,
  width: number,
  before: Step | undefined,
  after: Step | undefined,
): Point[] {
  const [one, two] = [before ?? after, after ?? before];
  if (!one || !two) return [];
  const bend = 1 + dot(one.out, two.out);
  if (bend < leastBend) return [plus(at, one.out, width), plus(at, two.out, width)];
  return [plus(at, plus(one.out, two.out), width / bend)];
}

/**
 * The band of an edge, without its corners.
 * @param points from start to end, with the piece to the left
 */
export function bandOf(points: readonly Point[], width: number): Band {
  const steps = points.slice(1).map((to, k): Step => {
    const from = points[k] ?? to;
    return {from, to, out: outOf(unit(minus(to, from)))};
  });
  const cut = points.map((at, k) => feet(at, width, steps[k - 1], steps[k]));
  const line = cut.flat();
  if (width === 0) return {cloth: [], cut: line};
  const turn = steps.slice(1).reduce((sum, {out}, k) => {
    return sum + Math.abs(turnBetween(steps[k]?.out ?? out, out));
  }, 0);
  const runsOn = steps.every(({from, to}, k) => {
    const [a, b] = [cut[k]?.at(-1), cut[k + 1]?.[0]];
    return a && b && dot(minus(b, a), minus(to, from)) > 0;
  });
  if (runsOn && turn < greatestTurn)
    return {cloth: [[...line, ...[...points].reverse()]], cut: line};
  const cloth = steps.flatMap(({from, to, out}, k) => {
    const [first, last] = [plus(from, out, width), plus(to, out, width)];
    const next = steps[k + 1]?.out;
    const wedge =
      next && cross(out, next) > 0
        ? [[to, last, ...(cut[k + 1] ?? []), plus(to, next, width)]]
        : [];
    return [[first, last, to, from], ...wedge];
  });
  return {cloth, cut: line};
}
