/** The point of a line that is nearest to a given point. */
import {between, distance, nearestShare, type Point} from './vectors.js';

export interface Near {
  readonly at: Point;
  readonly off: number;
  /** Index of the segment. */
  readonly step: number;
}

export function nearestOn(line: readonly Point[], point: Point, isClosed: boolean): Near {
  const last = isClosed ? line.length : line.length - 1;
  let [nearest, least] = [0, Infinity];
  for (let step = 0; step < last; step++) {
    const from = line[step];
    const to = line[step + 1] ?? line[0];
    if (!from || !to) continue;
    const share = nearestShare(from, to, point);
    const x = from[0] + share * (to[0] - from[0]) - point[0];
    const y = from[1] + share * (to[1] - from[1]) - point[1];
    const square = x * x + y * y;
    if (square < least) [nearest, least] = [step, square];
  }
  const from = line[nearest];
  const to = line[nearest + 1] ?? line[0];
  if (!from || !to || least === Infinity) return {at: from ?? point, off: Infinity, step: 0};
  const at = between(from, to, nearestShare(from, to, point));
  return {at, off: distance(at, point), step: nearest};
}
