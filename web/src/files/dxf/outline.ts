/** Divides a closed line of points into runs of curves between its corners. */
import type {Run} from '../../model/garment/imported-drawing.js';
import {distance, minus, turnBetween, radians, type Point} from '../../model/geometry/vectors.js';
import {cubicsOf, endOf, halved, mapped, straight, tracedLoop} from '../base/bezier.js';
import {crossing, straightened} from '../base/crossings.js';
import {pathThrough} from '../base/curve-fit.js';
import {runsOf} from '../base/edges.js';
import {splineThrough, type SplineRule} from '../base/splines.js';
import type {Loop} from './loops.js';

/** Greatest deviation of curves from a drawn line. [cm] */
const missed = 0.002;

/** Polylines within this distance of their curve are taken as the curve. [cm] */
const sagitta = 0.005;

/** Greatest distance of a turn point from the point it marks. [cm] */
const turnReach = 0.03;

/** Least turn of an unmarked corner; curves turn less between key points. */
const cornerTurn = {fine: radians(20), coarse: radians(50)};

interface OutlineRules {
  readonly cmPerUnit: number;
  /** Marked corners; empty if the file does not mark them. */
  readonly turnPoints: readonly Point[];
  /** The kind of spline through key points; undefined if lines are taken as drawn. */
  readonly rule?: SplineRule | undefined;
}

export interface Outline {
  readonly runs: readonly Run[];
  /** True if curves were interpolated through key points. */
  readonly isInterpolated: boolean;
}

/**
 * Divides a line.
 * @param loop points without repeating the first
 */
export function outlineOf(loop: Loop, rules: OutlineRules): Outline {
  if (loop.exact) return {runs: exactRuns(loop, loop.exact, rules), isInterpolated: false};
  const outline = pointOutline(loop, rules);
  return {...outline, runs: simpleRuns(outline.runs, loop.points, rules)};
}

/** The runs of a loop with curves of the file. */
function exactRuns({points, joints}: Loop, exact: Run, {cmPerUnit}: OutlineRules): readonly Run[] {
  const mm = 10 * cmPerUnit;
  const end = endOf(exact);
  const isMet = distance(end, exact.start) * mm <= 0.03;
  const closed = isMet ? exact : {...exact, cubics: [...exact.cubics, straight(end, exact.start)]};
  const at =
    (factor: number) =>
    ([x, y]: Point): Point => [factor * x, factor * y];
  const corners = joints.length > 1 ? joints.map((k) => points[k] ?? exact.start) : [];
  return runsOf(mapped(closed, at(mm)), corners.map(at(mm))).map((run) => mapped(run, at(1 / mm)));
}

/** The runs, or straight ones where curves through points cross each other and lines do not. */
function simpleRuns(
  runs: readonly Run[],
  points: readonly Point[],
  {cmPerUnit}: OutlineRules,
): readonly Run[] {
  const tolerance = missed / cmPerUnit;
  if (!crossing(tracedLoop(runs, tolerance)) || crossing(points)) return runs;
  return straightened(runs, points);
}

function pointOutline(loop: Loop, {cmPerUnit, turnPoints, rule}: OutlineRules): Outline {
  const {points} = loop;
  const isFine = (line: readonly Point[]): boolean => strays(line) * cmPerUnit <= sagitta;
  const marked = cornersOf(loop, turnPoints, turnReach / cmPerUnit);
  const corners =
    marked.length > 0
      ? marked
      : turnsOf([...points, ...points.slice(0, 2)], cornerTurn.fine)
          .map((k) => k % points.length)
          .sort((a, b) => a - b);
  const stretches =
    corners.length > 0
      ? stretchesOf(points, corners, 0)
      : stretchesOf(points, thirds(points.length), runUp);
  let isInterpolated = false;
  const runs = stretches.flatMap(({line, lead}): Run[] => {
    if (!rule || line.length === 2 || isFine(line)) {
      return cutAt(line, turnsOf(line, cornerTurn.fine)).map((part) => ({
        start: part[0] ?? [0, 0],
        cubics: pathThrough(part, missed / cmPerUnit),
      }));
    }
    isInterpolated = true;
    const turns = turnsOf(line, cornerTurn.coarse);
    if (turns.length > 0) return cutAt(line, turns).map((part) => splineRun(part, rule));
    const {start, cubics} = splineRun(lead.line, rule);
    return [
      {
        start: line[0] ?? start,
        cubics: cubics.slice(lead.from, lead.from + line.length - 1),
      },
    ];
  });
  return {runs: runs.length === 1 ? runs.flatMap(halves) : runs, isInterpolated};
}

/**
 * Number of points added before and after a part of a smooth closed curve, so that its ends fit.
 */
const runUp = 6;

interface Stretch {
  readonly line: readonly Point[];
  /** The part with points before and after it, and the index where it begins. */
  readonly lead: {readonly line: readonly Point[]; readonly from: number};
}

function stretchesOf(
  points: readonly Point[],
  corners: readonly number[],
  lead: number,
): Stretch[] {
  const count = points.length;
  const between = (from: number, to: number): Point[] =>
    Array.from({length: to - from + 1}, (_, k) => points[(from + k + count) % count] ?? [0, 0]);
  return corners.map((from, k) => {
    const next = corners[k + 1] ?? (corners[0] ?? 0) + count;
    const long = Math.min(lead, count - 1);
    return {line: between(from, next), lead: {line: between(from - long, next + long), from: long}};
  });
}

const thirds = (count: number): number[] => [0, Math.floor(count / 3), Math.floor((2 * count) / 3)];

/** Limits of the number of turn points. */
const [few, many] = [40, 1000];

/** Corners: marked points and ends of drawn lines. */
function cornersOf({points, joints}: Loop, turnPoints: readonly Point[], reach: number): number[] {
  // a file that marks all points marks no corners
  const isTelling =
    turnPoints.length < few || turnPoints.length < Math.min(many, points.length / 2);
  const marked = new Set(joints.length > 1 ? joints : []);
  for (const turn of isTelling ? turnPoints : []) {
    let [best, off] = [-1, reach];
    points.forEach((point, k) => {
      const away = distance(point, turn);
      if (away <= off) [best, off] = [k, away];
    });
    if (best >= 0) marked.add(best);
  }
  return [...marked].sort((a, b) => a - b);
}

/** The angle between two segments. [rad] */
const turnAt = (before: Point, at: Point, after: Point): number =>
  Math.abs(turnBetween(minus(at, before), minus(after, at)));

/** Indices of the inner corners of a line; the last two points may repeat the first two. */
function turnsOf(line: readonly Point[], least: number): number[] {
  const turns: number[] = [];
  for (let k = 1; k + 1 < line.length; k++) {
    const [before, at, after] = [line[k - 1], line[k], line[k + 1]];
    if (before && at && after && turnAt(before, at, after) > least) turns.push(k);
  }
  return turns;
}

function cutAt(line: readonly Point[], turns: readonly number[]): (readonly Point[])[] {
  const cuts = [0, ...turns, line.length - 1];
  return cuts.slice(1).map((to, k) => line.slice(cuts[k], to + 1));
}

const splineRun = (line: readonly Point[], rule: SplineRule): Run => ({
  start: line[0] ?? [0, 0],
  cubics: splineThrough(line, rule),
});

/** The median distance of segments from the curve that they represent, assuming arcs. */
function strays(line: readonly Point[]): number {
  const strayed: number[] = [];
  for (let k = 1; k + 1 < line.length; k++) {
    const [before, at, after] = [line[k - 1], line[k], line[k + 1]];
    if (!before || !at || !after) continue;
    strayed.push(((distance(before, at) + distance(at, after)) / 16) * turnAt(before, at, after));
  }
  return strayed.sort((a, b) => a - b)[Math.floor(strayed.length / 2)] ?? 0;
}

function halves(run: Run): Run[] {
  const all = cubicsOf(run);
  const parts = all.length > 1 ? all : all.flatMap(halved);
  const cut = Math.floor(parts.length / 2);
  return [parts.slice(0, cut), parts.slice(cut)].map((part) => ({
    start: part[0]?.[0] ?? run.start,
    cubics: part.map(([, first, second, end]) => [first, second, end]),
  }));
}
