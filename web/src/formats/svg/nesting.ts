/** Classifies closed lines: pieces, lines inside others, and page frames. [mm] */
import type {Run} from '../../model/garment/imported-drawing.js';
import {distance, type Point} from '../../model/geometry/vectors.js';
import {boxOf, isInside, signedArea, type Box} from '../../model/geometry/polyline.js';
import {nearestOn} from '../base/nearest.js';
import type {Line} from './lines.js';
import {rimOf, runsOf} from './outlines.js';
import type {Drawn} from './walk.js';

/** Connected lines with the elements that draw them. */
export interface Stroke {
  readonly line: Line;
  readonly drawers: readonly Drawn[];
}

/** A closed line with its measures. */
export interface Loop extends Stroke {
  readonly rim: readonly Point[];
  readonly box: Box;
  /** [mm2] */
  readonly area: number;
}

/** Least area of a piece; smaller lines are marks. [mm2] */
export const leastPiece = 2500;

export const longerSide = ({low, high}: Box): number =>
  Math.max(high[0] - low[0], high[1] - low[1]);

/** All closed lines, the largest first, without duplicates. */
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

/** Rounding tolerance of folds, where sewn and cut line coincide. [mm] */
const touching = 0.5;

/**
 * Returns whether a line is inside another, by its bounding box and most of its points, since edges
 * may coincide.
 */
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

/** Greatest allowance, wider than any hem. [mm] */
const widest = 60;

/**
 * Returns whether a line is the cut line around a sewn line. It is close everywhere, and its
 * distance changes little except at corners: hems have a wider allowance and folds have none.
 */
export function isCutAround(outer: Loop, inner: Loop): boolean {
  if (inner.area < 0.4 * outer.area) return false;
  const gaps = alongEvenly(inner.rim, 96).map((p) => nearestOn(outer.rim, p, true).off);
  const steady = gaps.filter((gap, k) => Math.abs(gap - (gaps.at(k - 1) ?? gap)) <= unsteady);
  const usual = [...gaps].sort((a, b) => a - b)[Math.floor(gaps.length / 2)] ?? 0;
  return Math.max(...gaps) <= widest && usual > 1 && steady.length >= 0.7 * gaps.length;
}

/** Greatest change of the allowance from one hundredth of an outline to the next. [mm] */
const unsteady = 0.5;

/** Points of a closed line at even distances. */
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

/** Returns whether a line is a rectangle, in any rotation. */
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
