/** Allowed angles of a piece on its fabric. */
import type {Design} from './design.js';
import {angleOf, minus, radians, wrapped, type Point} from '../geometry/vectors.js';
import {isAllowed, type AngleRule} from '../print/mirror-lines.js';
import type {GrainLock} from '../garment/grain.js';

/** Grain line of files that give none. */
const upright: readonly [Point, Point] = [
  [0, 0],
  [0, 1],
];

/** Angles of the grain line from the length of the fabric. [degrees] */
const offsets: Readonly<Record<GrainLock, readonly number[]>> = {
  on: [0],
  across: [-90, 90],
  bias: [-45, 45],
  free: [0],
};

/** Greatest angle of a one-way print from upright where the grain is free. [degrees] */
const mostOffUpright = 60;

/**
 * Allowed angles of a piece; undefined when any angle is allowed.
 * @param line grain line of the face-up piece
 */
export function grainRule(
  {options, print}: Pick<Design, 'options' | 'print'>,
  name: string,
  [from, to]: readonly [Point, Point] = upright,
): AngleRule | undefined {
  const {default: all = 'free', toleranceDeg = 0, pieces = {}} = options.grain ?? {};
  const given = pieces[name] ?? all;
  const own = typeof given === 'string' ? {lock: given} : given;
  const {lock = all, angleDeg} = own;
  if (lock === 'free' && !print.oneWay) return undefined;
  const room = lock === 'free' ? mostOffUpright : (own.toleranceDeg ?? toleranceDeg);
  const line = angleDeg === undefined ? angleOf(minus(to, from)) : radians(angleDeg);
  // the grain line runs along +y of the print, the length of the fabric
  const angles = offsets[lock].map((degrees) => line - Math.PI / 2 + radians(degrees));
  const turned = print.oneWay || lock === 'across' ? [] : angles.map((angle) => angle + Math.PI);
  return {angles: [...angles, ...turned], tolerance: radians(room)};
}

/** Angle after a turn by these degrees, or the next allowed one in that sense. [rad] */
export function angleAfter(rule: AngleRule | undefined, from: number, degrees: number): number {
  const wanted = from + radians(degrees);
  if (!rule || isAllowed(wanted, rule)) return wanted;
  const sense = Math.sign(degrees);
  const ways = rule.angles.map((angle) => {
    const way = sense * wrapped(angle - from);
    return way > 1e-6 ? way : way + 2 * Math.PI;
  });
  return from + sense * Math.min(...ways);
}
