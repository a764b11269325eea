/** Closed lines: area, corners, and chaining of lines. [mm] */
import type {Run} from '../../model/garment/imported-drawing.js';
import {distance, minus, radians, turnBetween, type Point} from '../../model/geometry/vectors.js';
import {lengthOf, signedArea} from '../../model/geometry/polyline.js';
import {
  cubicsOf,
  endOf,
  halved,
  isStraight,
  reversed,
  tracedRun,
  type Cubic,
} from '../base/bezier.js';
import {pathThrough} from '../base/curve-fit.js';
import {meeting, type Line} from './lines.js';

/** Least turn between two edges; seams of patterns hardly ever end at a smaller one. [rad] */
const corner = radians(20);
/** Length up to which segments are ignored, since files are rounded to 0.01 mm. [mm] */
const shortestStep = 0.03;
/** Greatest deviation of traced points from a curve. [mm] */
const traceTolerance = 0.02;
/** Greatest deviation of a fitted curve from its points. [mm] */
const fitTolerance = 0.02;

/** Points along a line, including its ends. */
export const pointsOf = (line: Run): Point[] => tracedRun(line, traceTolerance);

/** Points of a closed line without repeating the first. */
export const rimOf = (loop: Run): Point[] => pointsOf(loop).slice(0, -1);

/** Enclosed area. [mm2] */
export const areaOf = (loop: Run): number => Math.abs(signedArea(rimOf(loop)));

/** The line without degenerate segments. */
function withoutDots(loop: Line): Line {
  let from = loop.start;
  const cubics = loop.cubics.filter((cubic) => {
    const isDot = cubic.every((p) => distance(p, from) < shortestStep);
    if (!isDot) from = cubic[2];
    return !isDot;
  });
  const last = cubics.pop();
  return {...loop, cubics: last ? [...cubics, [last[0], last[1], loop.start]] : cubics};
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
 */
export function runsOf(loop: Line): Run[] {
  const drawn = cubicsOf(withoutDots(loop));
  const cubics = drawn.length > 1 ? drawn : drawn.flatMap(halved);
  const ways = cubics.map(directions);
  const corners = ways.flatMap(({out}, k) =>
    Math.abs(turnBetween(ways.at(k - 1)?.into ?? out, out)) > corner ? [k] : [],
  );
  const [first = 0] = corners;
  const opposite = (first + Math.floor(cubics.length / 2)) % cubics.length;
  const cuts = corners.length > 1 ? corners : [first, opposite].sort((a, b) => a - b);
  return cuts.map((cut, k) => {
    const next = cuts[k + 1] ?? (cuts[0] ?? 0) + cubics.length;
    return runThrough([...cubics, ...cubics].slice(cut, next));
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
  const swings = lengthOf(pointsOf(curve)) > (1 + swing) * lengthOf(points);
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

/** Connected lines. */
interface Chain {
  readonly line: Line;
  /** Indices of the original lines. */
  readonly parts: readonly number[];
}

const backwards = (line: Line): Line => ({...reversed(line), isClosed: line.isClosed});

/**
 * Chains of lines whose ends meet within 0.1 mm, since many programs draw an outline edge by edge.
 * If more than two ends meet, the chain continues with the first line in the file.
 */
export function chained(lines: readonly Line[]): Chain[] {
  const ends = new Ends(lines);
  return lines.flatMap((first, k) => {
    if (!ends.take(k)) return [];
    let line = first;
    const parts = [k];
    for (let turn = 0; turn < 2 && !line.isClosed; turn++) {
      for (
        let next = ends.from(endOf(line));
        next && !line.isClosed;
        next = ends.from(endOf(line))
      ) {
        parts.push(next.number);
        line = joined(line, next.line);
      }
      if (!line.isClosed) line = backwards(line);
    }
    return [{line, parts}];
  });
}

function joined(a: Line, b: Line): Line {
  const cubics = [...a.cubics, ...b.cubics];
  const last = cubics.at(-1);
  const isClosed = last !== undefined && distance(last[2], a.start) <= meeting;
  if (isClosed) cubics[cubics.length - 1] = [last[0], last[1], a.start];
  return {start: a.start, cubics, isClosed};
}

/** Open lines indexed by their ends. */
class Ends {
  readonly #lines: readonly Line[];
  readonly #left: Set<number>;
  readonly #cells = new Map<string, number[]>();

  constructor(lines: readonly Line[]) {
    this.#lines = lines;
    this.#left = new Set(lines.keys());
    lines.forEach((line, k) => {
      if (line.isClosed) return;
      for (const end of [line.start, endOf(line)]) {
        const [key = ''] = keysAround(end, [0]);
        const cell = this.#cells.get(key);
        if (cell) cell.push(k);
        else this.#cells.set(key, [k]);
      }
    });
  }

  /** Removes a line, and returns whether it was still there. */
  take(number: number): boolean {
    return this.#left.delete(number);
  }

  /** Removes and returns a line that continues at a point, reversed if needed to start there. */
  from(end: Point): {readonly line: Line; readonly number: number} | undefined {
    const near = keysAround(end, [-1, 0, 1])
      .flatMap((key) => this.#cells.get(key) ?? [])
      .filter((k) => this.#left.has(k))
      .sort((a, b) => a - b);
    for (const number of near) {
      const line = this.#lines[number];
      if (!line) continue;
      const isAhead = distance(line.start, end) <= meeting;
      if (!isAhead && distance(endOf(line), end) > meeting) continue;
      this.#left.delete(number);
      return {line: isAhead ? line : backwards(line), number};
    }
    return undefined;
  }
}

function keysAround([x, y]: Point, offsets: readonly number[]): string[] {
  const [column, row] = [Math.floor(x / meeting), Math.floor(y / meeting)];
  return offsets.flatMap((dx) => offsets.map((dy) => `${column + dx} ${row + dy}`));
}
