/** The point of a line that is nearest to a given point. */
import {between, distance, nearestShare, type Point} from './vectors.js';

export interface Near {
  readonly at: Point;
  readonly off: number;
  /** Index of the segment. */
  readonly step: number;
}

export function nearestOn(line: readonly Point[], point: Point, isClosed: boolean): Near {
  let best: Near = {at: line[0] ?? point, off: Infinity, step: 0};
  line.forEach((from, step) => {
    const to = line[step + 1] ?? (isClosed ? line[0] : undefined);
    if (!to) return;
    const at = between(from, to, nearestShare(from, to, point));
    const off = distance(at, point);
    if (off < best.off) best = {at, off, step};
  });
  return best;
}
