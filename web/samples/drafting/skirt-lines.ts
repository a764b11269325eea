/** Lines of skirts: seams over the hip, hems and waists square to them, straight waistbands. */
import {leftOf, norm, plus, radians, type Point} from '../../src/model/geometry/vectors.js';
import {radiusOf, type Body} from './body.js';
import {curve, leaning, line, mirror, pointAt, trueTo, velocity, type Curve} from './curves.js';
import {edge, symmetricPanel, type Edge, type Panel, type Placement, type Side} from './panel.js';

/**
 * Placement around the hip.
 * @param angle from the middle of the front towards the wearer's left [degrees]
 * @param place `away`: distance from the hip; `height` of the origin [cm]
 */
export function aroundHip(
  body: Body,
  angle: number,
  {away, height}: {readonly away: number; readonly height: number},
): Placement {
  const radius = radiusOf(body.hip) + away;
  const [x, z] = [Math.sin(radians(angle)), Math.cos(radians(angle))];
  return {
    translation: [angle % 180 === 0 ? 0 : radius * x, height, radius * z],
    rotation: [0, angle, 0],
  };
}

/** The direction of travel at parameter t, as a unit vector. */
export function heading(seam: Curve, t: number): Point {
  const way = velocity(seam, t);
  return plus([0, 0], way, 1 / norm(way));
}

/** The lower edge from one seam to the next, square to both; both are given upwards. */
export function squareBelow(from: Curve, to: Curve): Curve {
  const onward = (seam: Curve): Point => plus([0, 0], leftOf(heading(seam, 0)), -1);
  return curve(from.from, onward(from), to.from, onward(to));
}

/**
 * The upper edge from one seam back to the one before it, square to both; both are given upwards.
 */
export function squareAbove(from: Curve, to: Curve): Curve {
  return curve(from.to, leftOf(heading(from, 1)), to.to, leftOf(heading(to, 1)));
}

/**
 * Shape of a seam over the hip, for its waist at the origin and the fabric at its -x side. [cm,
 * radians]
 */
interface HipSeam {
  /** x of the seam at the depth of the hip. */
  readonly atHip: number;
  readonly hipDepth: number;
  /** Outward angle of the seam at the hem; the flare increases on the way down. */
  readonly flare: number;
  readonly drop: number;
}

/** Angle between hip and hem, as a part of that at the hem. */
const meanFlare = 0.72;

/**
 * A seam from the hem up to the waist as one fair curve: concave below the hip, where it flares,
 * and round above.
 */
export function hipSeam({atHip, hipDepth, flare, drop}: HipSeam): Curve {
  const hem: Point = [atHip + (drop - hipDepth) * Math.tan(meanFlare * flare), -drop];
  const leant = (lean: number): Curve =>
    curve(hem, leaning(-flare), [0, 0], leaning(-lean), drop / 3, hipDepth / 3);
  const hipOf = (seam: Curve): number =>
    pointAt(
      seam,
      trueTo('the hip', -hipDepth, (t) => pointAt(seam, t)[1], 0, 1),
    )[0];
  return leant(trueTo('the hip', atHip, (lean) => hipOf(leant(lean)), -0.5, 1.2));
}

/** Straight edges one after another along +x, each with its name and length. */
export function strip(from: Point, parts: readonly (readonly [string, number])[]): Edge[] {
  let at = from;
  return parts.map(([name, long]) => {
    const start = at;
    at = plus(at, [long, 0]);
    return edge(name, line(start, at));
  });
}

/**
 * Half a waistband that is its own mirror image. Its lower edge is divided for its seams: the
 * middle part, and the parts towards the end. Origin: the middle of the lower edge.
 */
export function bandPanel(
  name: string,
  side: Side,
  middle: readonly [string, number],
  outward: readonly (readonly [string, number])[],
  height: number,
  placement: Placement,
): Panel {
  const low: Point = [middle[1] / 2, 0];
  const lower = strip(low, outward);
  const end = lower.at(-1)?.curve.to ?? low;
  const high = plus(end, [0, height]);
  return symmetricPanel(
    name,
    {
      bottom: edge(middle[0], line(mirror(low), low)),
      half: [...lower, edge('end', line(end, high))],
      top: edge('upper', line(high, mirror(high))),
      side,
    },
    placement,
  );
}
