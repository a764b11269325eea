/** Darts that open from an edge: a notch in the outline whose two legs are sewn to each other. */
import {
  distance,
  leftOf,
  middle,
  minus,
  norm,
  plus,
  rotated,
  type Point,
} from '../../src/model/geometry/vectors.js';
import {curve, line, pointAt, type Curve} from './curves.js';
import {heading} from './skirt-lines.js';

/** An edge with a dart in it, in the order of the outline. */
export interface DartedEdge {
  readonly before: Curve;
  readonly legs: readonly [Curve, Curve];
  readonly after: Curve;
}

/**
 * Opens a dart in an edge that runs counter-clockwise around its panel, at `share` of its length,
 * with `intake` and `depth` in cm. The rest of the edge is square to the legs, so that it continues
 * smoothly once the dart is sewn.
 */
export function withDart(whole: Curve, share: number, intake: number, depth: number): DartedEdge {
  const along = heading(whole, share);
  const mouth = pointAt(whole, share);
  const tip = plus(mouth, leftOf(along), depth);
  const squareTo = (corner: Point): Point => {
    const leg = minus(corner, tip);
    return leftOf(plus([0, 0], leg, 1 / norm(leg)));
  };
  const near = plus(mouth, along, -intake / 2);
  const far = plus(mouth, along, intake / 2);
  return {
    before: curve(whole.from, heading(whole, 0), near, squareTo(near)),
    legs: [line(near, tip), line(tip, far)],
    after: curve(far, squareTo(far), whole.to, heading(whole, 1)),
  };
}

/** A dart from the side seam towards the bust. */
interface BustDart {
  /** The legs from the side to the tip and back to the side, the lower leg first. */
  readonly legs: readonly [Curve, Curve];
  /**
   * Rotation of the side seam above the dart, so that it is straight once the dart is sewn.
   * [radians]
   */
  readonly opening: number;
}

/** Distance from the tip of a bust dart to the bust, as a part of the way there. */
const shortOfBust = 0.24;

/**
 * Rotates the panel above `lower`, a point of its side seam at the +x side, about the bust, so that
 * a dart of the given intake (cm) opens.
 */
export function bustDart(lower: Point, bust: Point, intake: number): BustDart {
  const opening = (centre: Point): number => 2 * Math.asin(intake / 2 / distance(lower, centre));
  const upper = plus(bust, rotated(minus(lower, bust), opening(bust)));
  const tip = plus(bust, minus(middle(lower, upper), bust), shortOfBust);
  return {legs: [line(lower, tip), line(tip, upper)], opening: opening(tip)};
}
