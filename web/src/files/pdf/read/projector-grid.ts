/** Removes the grid of projector files: long parallel lines at equal distances. Lengths in mm. */
import {boxOf} from '../../../model/geometry/polyline.js';
import type {InkLine} from './ink.js';

/** Least share of the sheet that a line of a grid spans, and least number of such lines. */
const spans = 0.85;
const least = 6;

/** Greatest difference between the distances of neighbours. */
const even = 0.5;

export function withoutGrid(lines: readonly InkLine[]): {
  readonly lines: readonly InkLine[];
  readonly notes: readonly string[];
} {
  const all = boxOf(lines.flatMap(({points}) => points));
  const inGrid = new Set<InkLine>();
  for (const axis of [0, 1] as const) {
    const whole = all.high[axis] - all.low[axis];
    const long = lines.filter(({points, isClosed}) => {
      if (isClosed || points.length > 3) return false;
      const {low, high} = boxOf(points);
      return high[axis] - low[axis] >= spans * whole && high[1 - axis] === low[1 - axis];
    });
    const places = [...new Set(long.map(({points}) => points[0]?.[1 - axis] ?? 0))].sort(
      (a, b) => a - b,
    );
    const steps = places.slice(1).map((place, k) => place - (places[k] ?? place));
    const usual = [...steps].sort((a, b) => a - b)[Math.floor(steps.length / 2)] ?? 0;
    const isEven =
      steps.filter((one) => Math.abs(one - usual) <= even).length >= 0.8 * steps.length;
    if (places.length >= least && isEven) for (const line of long) inGrid.add(line);
  }
  if (inGrid.size === 0) return {lines, notes: []};
  return {
    lines: lines.filter((line) => !inGrid.has(line)),
    notes: [`A grid of ${inGrid.size} lines is left out.`],
  };
}
