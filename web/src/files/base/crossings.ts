/** Finds crossings of a closed line with itself, and removes those of fitted curves. */
import type {Run} from '../../model/garment/imported-drawing.js';
import {cross, distance, minus, type Point} from '../../model/geometry/vectors.js';
import {endOf, straight} from './bezier.js';

/** Greatest number of compared pairs of segments. */
const mostPairs = 4_000_000;

/** The place where a closed line crosses itself; undefined if it does not. */
export function crossing(loop: readonly Point[]): Point | undefined {
  const count = loop.length;
  const segments = loop
    .map((from, k) => {
      const to = loop[(k + 1) % count] ?? from;
      return {from, to, k, low: Math.min(from[0], to[0]), high: Math.max(from[0], to[0])};
    })
    .sort((a, b) => a.low - b.low);
  let active: typeof segments = [];
  let pairs = 0;
  for (const one of segments) {
    active = active.filter(({high}) => high >= one.low);
    for (const other of active) {
      const apart = Math.abs(one.k - other.k);
      if (apart > 1 && apart < count - 1 && cuts(one, other)) return one.from;
      if (++pairs > mostPairs) return undefined;
    }
    active.push(one);
  }
  return undefined;
}

interface Segment {
  readonly from: Point;
  readonly to: Point;
}

/** Returns whether two segments cross each other at inner points of both. */
function cuts(a: Segment, b: Segment): boolean {
  const side = ({from, to}: Segment, p: Point): number => cross(minus(to, from), minus(p, from));
  return side(a, b.from) * side(a, b.to) < 0 && side(b, a.from) * side(b, a.to) < 0;
}

/**
 * Runs with straight lines between the points instead of curves.
 * @param points the points that the runs were put through, without repeating the first
 */
export function straightened(runs: readonly Run[], points: readonly Point[]): Run[] {
  const nearest = (at: Point): number =>
    points.reduce(
      (best, point, k) => (distance(point, at) < distance(points[best] ?? point, at) ? k : best),
      0,
    );
  return runs.map((run) => {
    const [from, to] = [nearest(run.start), nearest(endOf(run))];
    const count = (to - from + points.length) % points.length;
    const inner = Array.from({length: Math.max(0, count - 1)}, (_, k) => {
      return points[(from + 1 + k) % points.length] ?? run.start;
    });
    const line = [run.start, ...inner, endOf(run)];
    return {start: run.start, cubics: line.slice(1).map((at, k) => straight(line[k] ?? at, at))};
  });
}
