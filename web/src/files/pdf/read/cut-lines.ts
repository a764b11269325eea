/** Cuts lines at the sides of a box. */
import type {Box} from '../../../model/geometry/polyline.js';
import type {Point} from '../../../model/geometry/vectors.js';

interface CutLine {
  readonly points: readonly Point[];
  readonly isClosed: boolean;
}

export const isInBox = ({low, high}: Box, [x, y]: Point): boolean =>
  x >= low[0] && x <= high[0] && y >= low[1] && y <= high[1];

/** The common part of two boxes; low exceeds high if there is none. */
export const common = (a: Box, b: Box): Box => ({
  low: [Math.max(a.low[0], b.low[0]), Math.max(a.low[1], b.low[1])],
  high: [Math.min(a.high[0], b.high[0]), Math.min(a.high[1], b.high[1])],
});

/** The parameters from 0 to 1 between which a segment is in a box; undefined if nowhere. */
function insidePart(
  [ax, ay]: Point,
  [bx, by]: Point,
  {low, high}: Box,
): readonly [number, number] | undefined {
  let [from, to] = [0, 1];
  for (const [start, way, least, most] of [
    [ax, bx - ax, low[0], high[0]],
    [ay, by - ay, low[1], high[1]],
  ] as const) {
    if (way === 0) {
      if (start < least || start > most) return undefined;
      continue;
    }
    const [one, two] = [(least - start) / way, (most - start) / way];
    from = Math.max(from, Math.min(one, two));
    to = Math.min(to, Math.max(one, two));
  }
  return from < to ? [from, to] : undefined;
}

/** The parts of a line in a box. A line that is nowhere cut is returned as it is. */
export function partsInBox(line: CutLine, box: Box): CutLine[] {
  const {points, isClosed} = line;
  if (points.every((p) => isInBox(box, p))) return [line];
  const [first] = points;
  if (!first) return [];
  const all = isClosed ? [...points, first] : points;
  const parts: Point[][] = [];
  let part: Point[] | undefined;
  for (let k = 1; k < all.length; k++) {
    const [a, b] = [all[k - 1] ?? first, all[k] ?? first];
    const inside = insidePart(a, b, box);
    if (!inside) {
      part = undefined;
      continue;
    }
    const [from, to] = inside;
    const at = (t: number): Point => [a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])];
    if (!part || from > 0) parts.push((part = [from > 0 ? at(from) : a]));
    part.push(to < 1 ? at(to) : b);
    if (to < 1) part = undefined;
  }
  const [start, end] = [parts[0], parts.at(-1)];
  const isRound = isClosed && start && end && start !== end && end.at(-1) === first;
  if (isRound && start[0] === first) {
    parts[0] = [...end, ...start.slice(1)];
    parts.pop();
  }
  return parts.map((one) => ({points: one, isClosed: false}));
}
