/** Divides closed lines into runs from corner to corner. [mm] */
import type {Run} from '../../model/garment/imported-drawing.js';
import {distance, minus, radians, turnBetween, type Point} from '../../model/geometry/vectors.js';
import {lengthOf} from '../../model/geometry/polyline.js';
import {cubicsOf, halved, isStraight, tracedRun, type Cubic} from './bezier.js';
import {pathThrough} from './curve-fit.js';

/** Least turn between two edges; seams of patterns hardly ever end at a smaller one. [rad] */
const corner = radians(20);
/** Length up to which segments are ignored, since files are rounded to 0.01 mm. [mm] */
const shortestStep = 0.03;
/** Greatest deviation of traced points from a curve. [mm] */
export const traceTolerance = 0.02;
/** Greatest distance of a joint from the start of a curve. [mm] */
const meeting = 0.001;
/** Greatest deviation of a fitted curve from its points. [mm] */
const fitTolerance = 0.02;

/** The line without degenerate segments. */
function withoutDots(loop: Run): Run {
  let from = loop.start;
  const cubics = loop.cubics.filter((cubic) => {
    const isDot = cubic.every((p) => distance(p, from) < shortestStep);
    if (!isDot) from = cubic[2];
    return !isDot;
  });
  const last = cubics.pop();
  return {
    start: loop.start,
    cubics: last ? [...cubics, [last[0], last[1], loop.start]] : cubics,
  };
}

/** The directions of a curve at its start and end. */
function directions([from, a, b, to]: Cubic): {readonly out: Point; readonly into: Point} {
  const isApart = (p: Point, q: Point): boolean => distance(p, q) > 1e-4;
  const ahead = [a, b, to].find((p) => isApart(p, from)) ?? to;
  const behind = [b, a, from].find((p) => isApart(p, to)) ?? from;
  return {out: minus(ahead, from), into: minus(to, behind)};
}

/**
 * Runs of a closed line from corner to corner. A line with fewer than two corners is also divided
 * after half of its curves, since an edge has two ends.
 * @param joints points where separately drawn lines meet, which are corners
 */
export function runsOf(loop: Run, joints: readonly Point[] = []): Run[] {
  const drawn = cubicsOf(withoutDots(loop));
  const cubics = drawn.length > 1 ? drawn : drawn.flatMap(halved);
  const ways = cubics.map(directions);
  const isJoint = (start: Point): boolean => joints.some((at) => distance(at, start) < meeting);
  const corners = ways.flatMap(({out}, k) => {
    const turn = Math.abs(turnBetween(ways.at(k - 1)?.into ?? out, out));
    return turn > corner || isJoint(cubics[k]?.[0] ?? loop.start) ? [k] : [];
  });
  const [first = 0] = corners;
  const opposite = (first + Math.floor(cubics.length / 2)) % cubics.length;
  const cuts = corners.length > 1 ? corners : [first, opposite].sort((a, b) => a - b);
  const twice = [...cubics, ...cubics];
  return cuts.map((cut, k) => {
    const next = cuts[k + 1] ?? (cuts[0] ?? 0) + cubics.length;
    return runThrough(twice.slice(cut, next));
  });
}

/** A run; many short straight segments with small turns are converted to a curve. */
function runThrough(cubics: readonly Cubic[]): Run {
  const start = cubics[0]?.[0] ?? [0, 0];
  const drawn: Run = {start, cubics: cubics.map(([, a, b, to]) => [a, b, to])};
  if (cubics.length < 3 || !cubics.every((cubic) => isStraight(cubic, 1e-3))) return drawn;
  const points = [start, ...cubics.map((cubic) => cubic[3])];
  if (!isFine(points)) return drawn;
  const curve = {start, cubics: pathThrough(points, fitTolerance)};
  const swings = lengthOf(tracedRun(curve, traceTolerance)) > (1 + swing) * lengthOf(points);
  return swings ? drawn : curve;
}

/** A curve longer than its segments by this share swings between them. */
const swing = 0.002;

/**
 * Greatest distance of segments from the curve they represent, assuming arcs: the median and the
 * maximum. [mm]
 */
const strays = {usual: 0.1, most: 0.5};

function isFine(points: readonly Point[]): boolean {
  const off = points.slice(2).map((to, k) => {
    const [from = to, at = to] = [points[k], points[k + 1]];
    const turn = Math.abs(turnBetween(minus(at, from), minus(to, at)));
    return ((distance(from, at) + distance(at, to)) / 16) * turn;
  });
  const sorted = off.sort((a, b) => a - b);
  const usual = sorted[Math.floor(sorted.length / 2)] ?? 0;
  return usual <= strays.usual && (sorted.at(-1) ?? 0) <= strays.most;
}
