/** The line along which a piece is cut, as it is laid. Lengths in cm. */
import {cross, minus, type Point} from '../model/geometry.js';
import {signedArea} from '../model/polyline.js';

/** The outer one of a piece's cut lines, counter-clockwise; undefined where there is none. */
export function outerRing(cut: readonly (readonly Point[])[]): readonly Point[] | undefined {
  const [largest] = [...cut].sort(
    (one, other) => Math.abs(signedArea(other)) - Math.abs(signedArea(one)),
  );
  if (!largest || largest.length < 3) return undefined;
  return signedArea(largest) < 0 ? [...largest].reverse() : largest;
}

type Step = readonly [from: Point, to: Point];

/** Whether two steps pass through each other; to touch is no crossing. */
function passThrough([a, b]: Step, [c, d]: Step): boolean {
  const side = (p: Point, q: Point, r: Point): number => cross(minus(q, p), minus(r, p));
  return side(a, b, c) * side(a, b, d) < 0 && side(c, d, a) * side(c, d, b) < 0;
}

/** Where a closed line crosses itself: the start of the first step that does. */
export function selfCrossing(ring: readonly Point[]): Point | undefined {
  const steps = ring.map((from, k): Step => [from, ring[(k + 1) % ring.length] ?? from]);
  return steps.find((step, k) => steps.slice(k + 2).some((other) => passThrough(step, other)))?.[0];
}
