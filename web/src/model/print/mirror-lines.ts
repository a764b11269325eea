/** Places of a symmetric piece on a print: its axis is on one of the print's mirror lines. */
import {determinant, type PlaneMap} from '../geometry/plane-map.js';
import {
  angleOf,
  cross,
  dot,
  leftOf,
  lyingOn,
  middle,
  minus,
  norm,
  onPrint,
  plus,
  towards,
  wrapped,
  type Alignment,
  type MirrorMap,
  type Point,
} from '../geometry/vectors.js';
import {printElements, latticeAround, reduced, reducedBasis, type Repeat} from './wallpaper.js';

/**
 * Parallel mirror lines of a print at equal distances, in points of the print. Glide lines are not
 * included.
 */
interface MirrorLines {
  /** Unit vector. */
  readonly along: Point;
  /** Position of one of them along the normal (-y, x) of `along`. [cm] */
  readonly offset: number;
  /** Distance from one to the next. [cm] */
  readonly spacing: number;
  /** The lines through the print's motifs are at the multiples of this along the normal. [cm] */
  readonly motifs: number;
}

/** Tolerance for lattices from files, as a share of their sides. */
const tolerance = 1e-4;
/** Lattice vectors along the axes have coordinates up to this in a reduced basis. */
const reach = 3;

export function mirrorLines(repeat: Repeat): readonly MirrorLines[] {
  const [a, b] = reducedBasis(repeat.w1, repeat.w2);
  const vectors = latticeAround([a, b], reach);
  const near = tolerance * norm(a);
  const area = Math.abs(cross(a, b));
  const shortest = (along: Point): number =>
    Math.min(
      ...vectors
        .filter((vector) => Math.abs(dot(vector, leftOf(along))) < near)
        .map((vector) => Math.abs(dot(vector, along)))
        .filter((length) => length > near),
    );
  return mirrored(repeat).flatMap(({xx, xy, yx, yy, shift}): MirrorLines[] => {
    const along = towards(angleOf([xx - yy, yx + xy]) / 2);
    const normal = leftOf(along);
    const rest = reduced(repeat, shift);
    // a mirror shifts nothing along its axis, possibly after adding a lattice vector; all others
    // are glides
    const whole = vectors
      .map((vector) => plus(rest, vector))
      .find((sum) => Math.abs(dot(sum, along)) < near);
    if (!whole) return [];
    const spacing = shortest(normal) / 2;
    return [{along, offset: dot(whole, normal) / 2, spacing, motifs: area / shortest(along)}];
  });
}

/** Symmetries of the print that mirror it, one per linear part. */
export const mirrored = (repeat: Repeat): readonly PlaneMap[] =>
  printElements(repeat).filter((element) => determinant(element) < 0);

/** Allowed angles of a piece, all with the same tolerance. [rad] */
export interface AngleRule {
  readonly angles: readonly number[];
  readonly tolerance: number;
}

export const isAllowed = (angle: number, rule: AngleRule | undefined): boolean =>
  !rule || rule.angles.some((one) => Math.abs(wrapped(angle - one)) <= rule.tolerance + 1e-6);

/** Possible places of a symmetric piece: its axis on any of these lines, at this angle. */
interface MirrorPlace extends MirrorLines {
  readonly angle: number;
}

/** Direction of the axis of a reflection p' = R F p + t. [rad] */
const axisAngle = (map: MirrorMap): number => (map.angle - Math.PI) / 2;

/** The point of the axis of p' = R F p + t that is nearest to `p`. */
export function footOnAxis(map: MirrorMap, p: Point): Point {
  const along = towards(axisAngle(map));
  const onAxis = middle([0, 0], map.translation);
  return plus(onAxis, along, dot(minus(p, onAxis), along));
}

/** All possible places of a piece with this reflection; none on a print without mirrors. */
function mirrorPlaces(repeat: Repeat, map: MirrorMap, rule?: AngleRule): readonly MirrorPlace[] {
  return mirrorLines(repeat)
    .flatMap((lines) => [lines, {...lines, ...turnedRound(lines)}])
    .map((lines) => ({
      ...lines,
      angle: wrapped(axisAngle(map) - angleOf(lines.along)),
    }))
    .filter(({angle}) => isAllowed(angle, rule));
}

/** The same lines in the opposite direction. */
const turnedRound = ({along: [x, y], offset}: MirrorLines): Partial<MirrorLines> => ({
  along: [0 - x, 0 - y],
  offset: 0 - offset,
});

/** The point nearest to `point` on the nearest of the lines, and the distance to it. */
function ontoLine(
  {along, offset, spacing}: MirrorLines,
  point: Point,
): {readonly at: Point; readonly shift: number} {
  const normal = leftOf(along);
  const off = dot(point, normal) - offset;
  const shift = off - spacing * Math.round(off / spacing);
  return {at: plus(point, normal, -shift), shift: Math.abs(shift)};
}

/**
 * The alignment nearest to `wanted` (least turn, then least shift across the axis) that puts the
 * axis of a symmetric piece on a mirror line of the print. Undefined where there is none.
 * @param map the piece's own reflection, p' = R F p + t
 * @param about point of the piece; turns are about the axis point nearest to it
 */
export function nearestMirrored(
  repeat: Repeat,
  map: MirrorMap,
  wanted: Alignment,
  about: Point,
  rule?: AngleRule,
): Alignment | undefined {
  const foot = footOnAxis(map, about);
  const point = onPrint(wanted, foot);
  let best: {readonly turn: number; readonly shift: number; readonly at: Alignment} | undefined;
  for (const place of mirrorPlaces(repeat, map, rule)) {
    const turn = Math.abs(wrapped(place.angle - wanted.angle));
    const {at, shift} = ontoLine(place, point);
    const isBetter =
      !best || turn < best.turn - 1e-9 || (turn < best.turn + 1e-9 && shift < best.shift - 1e-9);
    if (isBetter) best = {turn, shift, at: lyingOn(place.angle, foot, at)};
  }
  return best?.at;
}

/**
 * The alignment at the next allowed angle of a symmetric piece in a sense of rotation, with the
 * print turned about `about`.
 */
export function nextMirrored(
  repeat: Repeat,
  map: MirrorMap,
  from: Alignment,
  about: Point,
  sense: 1 | -1,
  rule?: AngleRule,
): Alignment | undefined {
  const turn = (angle: number): number => {
    const way = sense * wrapped(angle - from.angle);
    return way > 1e-6 ? way : way + 2 * Math.PI;
  };
  const angles = mirrorPlaces(repeat, map, rule).map(({angle}) => angle);
  const next = angles.sort((one, other) => turn(one) - turn(other))[0];
  if (next === undefined) return undefined;
  const foot = footOnAxis(map, about);
  const wanted = lyingOn(next, foot, onPrint(from, foot));
  return nearestMirrored(repeat, map, wanted, about);
}

/** The mirror line of the print on the axis of a symmetric piece. */
interface AxisLine {
  /** Unit vector of the axis, in the piece's coordinates. */
  readonly along: Point;
  /** Distance to the next possible line for the axis. [cm] */
  readonly spacing: number;
  /** The axis runs through motifs, which are at the print's origin. */
  readonly isOnMotif: boolean;
}

/** Undefined where the axis is not parallel to mirror lines of the print. */
export function axisLine(
  repeat: Repeat,
  map: MirrorMap,
  alignment: Alignment,
): AxisLine | undefined {
  const axis = axisAngle(map);
  const angle = axis - alignment.angle;
  const lines = mirrorLines(repeat).find(
    ({along}) => Math.abs(Math.sin(angleOf(along) - angle)) < 1e-6,
  );
  if (!lines) return undefined;
  const {spacing, motifs} = lines;
  const off = dot(onPrint(alignment, footOnAxis(map, [0, 0])), leftOf(lines.along)) / motifs;
  return {
    along: towards(axis),
    spacing,
    isOnMotif: Math.abs(off - Math.round(off)) * motifs < 1e-3,
  };
}
