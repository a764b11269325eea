/** Darts that open from an edge: a notch in the outline whose two legs are sewn to each other. */
import {left, line, minus, norm, plus, pointAt, curve, type Curve, type Point} from './geometry.js';
import {heading} from './skirt-lines.js';

/** An edge with a dart in it, in the order of the outline. */
export interface DartedEdge {
  readonly before: Curve;
  readonly legs: readonly [Curve, Curve];
  readonly after: Curve;
}

/**
 * Opens a dart in an edge that runs counter-clockwise around its panel: `share` along it, so wide and so deep (cm). What
 * is left of the edge is square to the legs, so that it runs on when the dart is sewn.
 */
export function withDart(whole: Curve, share: number, intake: number, depth: number): DartedEdge {
  const along = heading(whole, share);
  const mouth = pointAt(whole, share);
  const tip = plus(mouth, left(along), depth);
  const squareTo = (corner: Point): Point => {
    const leg = minus(corner, tip);
    return left(plus([0, 0], leg, 1 / norm(leg)));
  };
  const near = plus(mouth, along, -intake / 2);
  const far = plus(mouth, along, intake / 2);
  return {
    before: curve(whole.from, heading(whole, 0), near, squareTo(near)),
    legs: [line(near, tip), line(tip, far)],
    after: curve(far, squareTo(far), whole.to, heading(whole, 1)),
  };
}
