/** Closed lines of an SVG: points, area, and joining of lines. [mm] */
import type {Run} from '../../model/garment/imported-drawing.js';
import type {Point} from '../../model/geometry/vectors.js';
import {signedArea} from '../../model/geometry/polyline.js';
import {straight, tracedRun} from '../base/bezier.js';
import {runOfChain, sortedByFirst} from '../base/chain.js';
import {chainsOf} from '../base/chains.js';
import {traceTolerance} from '../base/edges.js';
import type {Line} from './lines.js';

const traced = new WeakMap<Run, readonly Point[]>();

/** Points along a line, including its ends. */
export function pointsOf(line: Run): readonly Point[] {
  const known = traced.get(line);
  if (known) return known;
  const points = tracedRun(line, traceTolerance);
  traced.set(line, points);
  return points;
}

/** A line of straight segments, whose curves are made only where they are needed. */
export function straightLine(points: readonly Point[], isClosed: boolean): Line {
  const [start = [0, 0]] = points;
  const all = isClosed ? [...points, start] : points;
  const line: Line = {
    ...{start, isClosed},
    get cubics() {
      return all.slice(1).map((to, k) => straight(all[k] ?? start, to));
    },
  };
  traced.set(line, all);
  return line;
}

/** Points of a closed line without repeating the first. */
export const rimOf = (loop: Run): Point[] => pointsOf(loop).slice(0, -1);

/** Enclosed area. [mm2] */
export const areaOf = (loop: Run): number => Math.abs(signedArea(rimOf(loop)));

/** Greatest gap between ends that meet. Wider ones than `meeting` are reported. [mm] */
const reach = 0.3;

/** Connected lines. */
interface Chain {
  readonly line: Line;
  /** Indices of the original lines. */
  readonly parts: readonly number[];
  /** The widest gap between them, and its place. */
  readonly gap: {readonly width: number; readonly at: Point};
}

/**
 * Joins lines whose ends meet, since many programs draw an outline edge by edge, and finds the
 * outlines of nets of lines. In the order of the lines.
 */
export function chained(lines: readonly Line[]): Chain[] {
  const open = lines.flatMap((line, k) => (line.isClosed ? [] : [{line, k}]));
  const joined = chainsOf(
    open.map(({line}) => ({points: pointsOf(line), run: line})),
    reach,
  ).map((chain): Chain => {
    const {isClosed, stretches, gap} = chain;
    const parts = stretches.map(({id}) => open[id]?.k ?? 0);
    const [part = 0] = parts;
    const only = lines[part];
    const isWhole =
      !isClosed && stretches.length === 1 && only && stretches[0]?.points === pointsOf(only);
    return {line: isWhole ? only : {...runOfChain(chain), isClosed}, parts, gap};
  });
  const whole = lines.flatMap((line, k): Chain[] =>
    line.isClosed ? [{line, parts: [k], gap: {width: 0, at: line.start}}] : [],
  );
  return sortedByFirst([...whole, ...joined], ({parts}) => parts);
}
