/** The cut line of a piece in a layout. Lengths in cm. */
import {cross, minus, type Point} from '../model/geometry/vectors.js';
import {boxOf, signedArea} from '../model/geometry/polyline.js';

/** The outermost of a piece's cut lines, counter-clockwise; undefined if it has none. */
export function outerRing(cut: readonly (readonly Point[])[]): readonly Point[] | undefined {
  const [largest] = [...cut].sort(
    (one, other) => Math.abs(signedArea(other)) - Math.abs(signedArea(one)),
  );
  if (!largest || largest.length < 3) return undefined;
  return signedArea(largest) < 0 ? [...largest].reverse() : largest;
}

/** A segment of a line with its bounding box. */
interface Step {
  readonly from: Point;
  readonly to: Point;
  readonly low: Point;
  readonly high: Point;
}

const stepOf = (from: Point, to: Point): Step => ({from, to, ...boxOf([from, to])});

const isApart = (one: Step, other: Step): boolean =>
  one.high[0] < other.low[0] ||
  other.high[0] < one.low[0] ||
  one.high[1] < other.low[1] ||
  other.high[1] < one.low[1];

/** Returns whether two segments cross; touching is not crossing. */
function passThrough({from: a, to: b}: Step, {from: c, to: d}: Step): boolean {
  const side = (p: Point, q: Point, r: Point): number => cross(minus(q, p), minus(r, p));
  return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

/** The start of a segment where a closed line crosses itself; undefined if it does not. */
export function selfCrossing(ring: readonly Point[]): Point | undefined {
  const steps = ring.map((from, k) => stepOf(from, ring[(k + 1) % ring.length] ?? from));
  // sorted from left to right, so that each segment meets only those that begin before it ends
  const sorted = [...steps].sort((one, other) => one.low[0] - other.low[0]);
  for (const [k, step] of sorted.entries()) {
    for (let n = k + 1; n < sorted.length; n++) {
      const other = sorted[n];
      if (!other || other.low[0] > step.high[0]) break;
      if (!isApart(step, other) && passThrough(step, other)) return step.from;
    }
  }
  return undefined;
}
