/** Relations between closed lines: one inside another, around another, or the same. [mm] */
import {
  between,
  distance,
  minus,
  radians,
  turnBetween,
  type Point,
} from '../../model/geometry/vectors.js';
import {boxOf, isInside, signedArea, type Box} from '../../model/geometry/polyline.js';
import {nearestOn} from '../../model/geometry/nearest.js';

/** A closed line with its measures. */
export interface ClosedLine {
  /** Points along the line without repeating the first. */
  readonly rim: readonly Point[];
  readonly box: Box;
  /** [mm2] */
  readonly area: number;
}

/** A text on the drawing. */
export interface Words {
  readonly at: Point;
  readonly lines: readonly string[];
}

export const closedLine = (rim: readonly Point[]): ClosedLine => ({
  rim,
  box: boxOf(rim),
  area: Math.abs(signedArea(rim)),
});

export const longerSide = ({low, high}: Box): number =>
  Math.max(high[0] - low[0], high[1] - low[1]);

/** Greatest distance between the boxes of a line and its copy. [mm] */
const same = 0.2;

/** Returns whether one line repeats another. */
export const isTheSame = (a: ClosedLine, b: ClosedLine): boolean =>
  Math.abs(a.area - b.area) <= 1e-3 * b.area &&
  distance(a.box.low, b.box.low) <= same &&
  distance(a.box.high, b.box.high) <= same &&
  sampled(b.rim, 12).every((p) => nearestOn(a.rim, p, true).off <= same);

const sampled = (rim: readonly Point[], count: number): Point[] => {
  const every = Math.max(1, Math.floor(rim.length / count));
  return rim.filter((_, k) => k % every === 0);
};

/** Rounding tolerance of folds, where sewn and cut line coincide. [mm] */
const touching = 0.5;

/**
 * Returns whether a line is inside another, by its bounding box and most of its points, since edges
 * may coincide.
 */
export function liesIn(inner: ClosedLine, outer: ClosedLine): boolean {
  const {low, high} = outer.box;
  const isWithin =
    inner.box.low[0] >= low[0] - touching &&
    inner.box.low[1] >= low[1] - touching &&
    inner.box.high[0] <= high[0] + touching &&
    inner.box.high[1] <= high[1] + touching;
  if (!isWithin || inner.area > outer.area) return false;
  const some = sampled(inner.rim, 24);
  const isThere = (p: Point): boolean =>
    isInside(outer.rim, p) || nearestOn(outer.rim, p, true).off <= touching;
  return some.filter(isThere).length >= 0.9 * some.length;
}

/** Returns whether two lines enclose a common area, and neither lies in the other. */
export function overlap(a: ClosedLine, b: ClosedLine): boolean {
  const isApart = ([0, 1] as const).some(
    (k) => a.box.high[k] <= b.box.low[k] || b.box.high[k] <= a.box.low[k],
  );
  if (isApart || liesIn(a, b) || liesIn(b, a)) return false;
  const isDeep = (p: Point, outer: ClosedLine): boolean =>
    isInside(outer.rim, p) && nearestOn(outer.rim, p, true).off > touching;
  return (
    sampled(a.rim, 24).some((p) => isDeep(p, b)) || sampled(b.rim, 24).some((p) => isDeep(p, a))
  );
}

/** Greatest allowance, wider than any hem. [mm] */
const widest = 60;

/** Greatest change of the allowance from one hundredth of an outline to the next. [mm] */
const unsteady = 0.5;

/** Least shares of a sewn line: within reach of its cut line, and at a steady distance from it. */
const alongside = {near: 0.7, steady: 0.6};

/**
 * Returns whether a line is the cut line around a sewn line. It is at a steady distance except at
 * corners: hems have a wider allowance, folds have none, and cut lines pass over darts.
 */
export function isCutAround(outer: ClosedLine, inner: ClosedLine): boolean {
  if (inner.area < 0.4 * outer.area || !liesIn(inner, outer)) return false;
  const gaps = alongEvenly(inner.rim, 96).map((p) => nearestOn(outer.rim, p, true).off);
  const count = (is: (gap: number, k: number) => boolean): number => gaps.filter(is).length;
  const near = count((gap) => gap <= widest);
  const steady = count(
    (gap, k) => gap <= widest && Math.abs(gap - (gaps.at(k - 1) ?? gap)) <= unsteady,
  );
  const usual = [...gaps].sort((a, b) => a - b)[Math.floor(gaps.length / 2)] ?? 0;
  return (
    usual > 1 && near >= alongside.near * gaps.length && steady >= alongside.steady * gaps.length
  );
}

/** Points of a closed line at even distances. */
function alongEvenly(rim: readonly Point[], count: number): Point[] {
  const lengths = rim.map((from, k) => distance(from, rim[(k + 1) % rim.length] ?? from));
  const step = lengths.reduce((sum, one) => sum + one, 0) / count;
  let gone = 0;
  return rim.flatMap((from, k) => {
    const to = rim[(k + 1) % rim.length] ?? from;
    const [length, points]: [number, Point[]] = [lengths[k] ?? 0, []];
    for (; gone < length; gone += step) points.push(between(from, to, gone / length));
    gone -= length;
    return points;
  });
}

/** Greatest turn within a side of a rectangle, and greatest error of its right angles. */
const upright = radians(0.5);

/** Returns whether a line is a rectangle, in any rotation. */
export function isRectangle(rim: readonly Point[]): boolean {
  const turns = rim
    .map((at, k) => {
      const [before, after] = [rim.at(k - 1) ?? at, rim[(k + 1) % rim.length] ?? at];
      return Math.abs(turnBetween(minus(at, before), minus(after, at)));
    })
    .filter((turn) => turn > upright);
  return turns.length === 4 && turns.every((turn) => Math.abs(turn - Math.PI / 2) < upright);
}

/** The direction of y in coordinates that notes name; lines always have y up. */
export type YAxis = 'up' | 'down';

/** A point in centimetres, for notes. */
export const pointText = ([x, y]: Point, axis: YAxis): string =>
  `x ${(x / 10).toFixed(1)} cm, y ${((axis === 'up' ? y : 0 - y) / 10).toFixed(1)} cm`;

/** The place and size of a line, for notes. */
export function placeOf({box: {low, high}}: ClosedLine, axis: YAxis): string {
  const cm = (length: number): string => (length / 10).toFixed(1);
  const size = `${cm(high[0] - low[0])} x ${cm(high[1] - low[1])} cm`;
  return `${size} at ${pointText([low[0], axis === 'up' ? low[1] : high[1]], axis)}`;
}
