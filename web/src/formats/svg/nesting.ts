/** Which of closed lines are pieces, which lie in others, and which frame a page. [mm] */
import type {Run} from '../../model/drawing.js';
import {distance, type Point} from '../../model/geometry.js';
import {boxOf, isInside, signedArea, type Box} from '../../model/polyline.js';
import {nearestOn} from '../base/nearest.js';
import type {Line} from './lines.js';
import {rimOf, runsOf} from './outlines.js';
import type {Drawn} from './walk.js';

/** Lines that hang together, and what drew them. */
export interface Stroke {
  readonly line: Line;
  readonly drawers: readonly Drawn[];
}

/** A closed line, measured. */
export interface Loop extends Stroke {
  readonly rim: readonly Point[];
  readonly box: Box;
  /** [mm2] */
  readonly area: number;
}

/** What a piece has at least; smaller ones are marks. [mm2] */
export const leastPiece = 2500;

export const longerSide = ({low, high}: Box): number =>
  Math.max(high[0] - low[0], high[1] - low[1]);

/** All closed lines, the largest first; what is drawn twice counts once. */
export function loopsOf(strokes: readonly Stroke[]): Loop[] {
  const loops = strokes
    .filter(({line}) => line.isClosed)
    .map(({line, drawers}): Loop => {
      const rim = rimOf(line);
      return {line, drawers, rim, box: boxOf(rim), area: Math.abs(signedArea(rim))};
    })
    .sort((a, b) => b.area - a.area);
  return loops.filter((loop, k) => !isTheSame(loops[k - 1], loop));
}

const same = 0.2;

const isTheSame = (a: Loop | undefined, b: Loop): boolean =>
  a !== undefined &&
  a.area - b.area <= 1e-3 * b.area &&
  distance(a.box.low, b.box.low) <= same &&
  distance(a.box.high, b.box.high) <= same;

/** Folds of sewn and of cut lines lie on each other, to within what programs round. [mm] */
const touching = 0.5;

/** Whether one lies in the other: by its box, and by most of its points, since edges may lie on each other. */
export function liesIn(inner: Loop, outer: Loop): boolean {
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

const sampled = (rim: readonly Point[], count: number): readonly Point[] =>
  rim.filter((_, k) => k % Math.max(1, Math.floor(rim.length / count)) === 0);

/** Wider allowances than people leave at hems. [mm] */
const widest = 60;

/**
 * Whether a line runs around another one as a cut line around a sewn one: nowhere far from it, and at a distance that hardly
 * changes but at corners. Hems have a wider allowance, and folds have none.
 */
export function isCutAround(outer: Loop, inner: Loop): boolean {
  if (inner.area < 0.4 * outer.area) return false;
  const gaps = alongEvenly(inner.rim, 96).map((p) => nearestOn(outer.rim, p, true).off);
  const steady = gaps.filter((gap, k) => Math.abs(gap - (gaps.at(k - 1) ?? gap)) <= unsteady);
  const usual = [...gaps].sort((a, b) => a - b)[Math.floor(gaps.length / 2)] ?? 0;
  return Math.max(...gaps) <= widest && usual > 1 && steady.length >= 0.7 * gaps.length;
}

/** By how much an allowance may change from one hundredth of an outline to the next. [mm] */
const unsteady = 0.5;

/** Points of a closed line at even steps. */
function alongEvenly(rim: readonly Point[], count: number): Point[] {
  const lengths = rim.map((from, k) => distance(from, rim[(k + 1) % rim.length] ?? from));
  const step = lengths.reduce((sum, one) => sum + one, 0) / count;
  let gone = 0;
  return rim.flatMap((from, k) => {
    const to = rim[(k + 1) % rim.length] ?? from;
    const [length, points]: [number, Point[]] = [lengths[k] ?? 0, []];
    for (; gone < length; gone += step) {
      const share = gone / length;
      points.push([from[0] + share * (to[0] - from[0]), from[1] + share * (to[1] - from[1])]);
    }
    gone -= length;
    return points;
  });
}

/** Whether a line is a rectangle, whichever way it lies. */
export function isRectangle(line: Line): boolean {
  const runs: readonly Run[] = runsOf(line);
  const corners = runs.map(({start}) => start);
  const [a, b, c, d] = corners;
  if (!a || !b || !c || !d || runs.length !== 4 || runs.some(({cubics}) => cubics.length > 1)) {
    return false;
  }
  const diagonal = distance(a, c);
  return (
    Math.abs(diagonal - distance(b, d)) <= 1e-3 * diagonal &&
    Math.abs(distance(a, b) - distance(c, d)) <= 1e-3 * diagonal &&
    Math.abs(distance(b, c) - distance(d, a)) <= 1e-3 * diagonal
  );
}
