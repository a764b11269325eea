/** Moves closed lines inwards. Lengths in mm. */
import {Clipper, EndType, FillRule, JoinType} from 'clipper2-ts';

import {cross, dot, minus, plus, unit, type Point} from '../../../model/geometry/vectors.js';
import {signedArea} from '../../../model/geometry/polyline.js';

/** Decimal places in clipping. */
const precision = 4;
/** Greatest length of a corner, in widths. */
const miter = 4;
/** Size of the half plane beside a fold. */
const far = 1e5;

type Paths = {x: number; y: number}[][];

const pathOf = (points: readonly Point[]): Paths => [points.map(([x, y]) => ({x, y}))];

function largest(paths: Paths): readonly Point[] | undefined {
  const loops = paths.map((path) => path.map(({x, y}): Point => [x, y]));
  return loops.sort((a, b) => Math.abs(signedArea(b)) - Math.abs(signedArea(a)))[0];
}

const inwards = (paths: Paths, width: number): Paths =>
  Clipper.inflatePathsD(paths, -width, JoinType.Miter, EndType.Polygon, miter, precision);

/** The line at a distance inside a closed line; undefined if nothing is left. */
export const inset = (rim: readonly Point[], width: number): readonly Point[] | undefined =>
  largest(inwards(pathOf(counterClockwise(rim)), width));

/** The same for half a piece, which keeps its edge on the fold. */
export function insetToFold(
  rim: readonly Point[],
  [from, to]: readonly [Point, Point],
  width: number,
): readonly Point[] | undefined {
  const along = unit(minus(to, from));
  const mirrored = rim.map((p): Point => {
    const foot = plus(from, along, dot(minus(p, from), along));
    return plus(foot, minus(foot, p));
  });
  const both = [counterClockwise(rim), counterClockwise(mirrored)].flatMap(pathOf);
  const whole = Clipper.unionD(both, [], FillRule.NonZero, precision);
  const side = Math.sign(rim.reduce((sum, p) => sum + cross(along, minus(p, from)), 0));
  const out: Point = [-side * along[1], side * along[0]];
  const corners = [
    plus(from, along, -far),
    plus(from, along, far),
    plus(plus(from, along, far), out, far),
    plus(plus(from, along, -far), out, far),
  ];
  const half = pathOf(counterClockwise(corners));
  return largest(Clipper.intersectD(inwards(whole, width), half, FillRule.NonZero, precision));
}

const counterClockwise = (rim: readonly Point[]): readonly Point[] =>
  signedArea(rim) < 0 ? [...rim].reverse() : rim;
