/** Where a symmetric piece may lie on a print: with its axis on one of the print's mirror lines. */
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
} from './geometry.js';
import {
  determinant,
  printElements,
  latticeAround,
  reduced,
  reducedBasis,
  type PlaneMap,
  type Repeat,
} from './wallpaper.js';

/** Parallel mirror lines of a print, at equal distances; glide lines are none. Points of the print. */
interface MirrorLines {
  /** Of length 1. */
  readonly along: Point;
  /** Where one of them lies along the normal (-y, x) of `along`. [cm] */
  readonly offset: number;
  /** From one to the next. [cm] */
  readonly spacing: number;
  /** The lines through the print's motifs lie at the multiples of this along the normal. [cm] */
  readonly motifs: number;
}

/** As far as lattices of files may be off, as a share of their sides. */
const tolerance = 1e-4;
/** Lattice vectors along the axes of a reduced basis have no greater coordinates. */
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
    // a mirror has no part along its axis; else it is a glide, with every lattice vector
    const whole = vectors
      .map((vector) => plus(rest, vector))
      .find((sum) => Math.abs(dot(sum, along)) < near);
    if (!whole) return [];
    const spacing = shortest(normal) / 2;
    return [{along, offset: dot(whole, normal) / 2, spacing, motifs: area / shortest(along)}];
  });
}

/** Symmetries of the print that turn it over, one per linear part. */
export const mirrored = (repeat: Repeat): readonly PlaneMap[] =>
  printElements(repeat).filter((element) => determinant(element) < 0);

/** Angles that a piece may have, each with a tolerance. [rad] */
export interface AngleRule {
  readonly angles: readonly number[];
  readonly tolerance: number;
}

export const isAllowed = (angle: number, rule: AngleRule | undefined): boolean =>
  !rule || rule.angles.some((one) => Math.abs(wrapped(angle - one)) <= rule.tolerance + 1e-6);

/** A way for a symmetric piece to lie: its axis on any of these lines, at this angle. */
interface MirrorPlace extends MirrorLines {
  readonly angle: number;
}

/** Where the axis of a reflection p' = R F p + t runs. [rad] */
const axisAngle = (map: MirrorMap): number => (map.angle - Math.PI) / 2;

/** The point of the axis of p' = R F p + t that is nearest to a point. */
export function footOnAxis(map: MirrorMap, p: Point): Point {
  const along = towards(axisAngle(map));
  const onAxis = middle([0, 0], map.translation);
  return plus(onAxis, along, dot(minus(p, onAxis), along));
}

/** All ways for a piece with this reflection to lie; none on a print without mirrors. */
function mirrorPlaces(repeat: Repeat, map: MirrorMap, rule?: AngleRule): readonly MirrorPlace[] {
  return mirrorLines(repeat)
    .flatMap((lines) => [lines, {...lines, ...turnedRound(lines)}])
    .map((lines) => ({
      ...lines,
      angle: wrapped(axisAngle(map) - angleOf(lines.along)),
    }))
    .filter(({angle}) => isAllowed(angle, rule));
}

/** The same lines, run along the other way. */
const turnedRound = ({along: [x, y], offset}: MirrorLines): Partial<MirrorLines> => ({
  along: [0 - x, 0 - y],
  offset: 0 - offset,
});

/** The line of a place that is nearest to a point of the print, and the nearest point on it. */
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
 * The alignment nearest to `wanted` (least turn, then least shift across the axis) that puts the axis of a
 * symmetric piece on a mirror line of the print. Undefined where there is none.
 * @param map the piece's own reflection, p' = R F p + t
 * @param about turns are about the axis point nearest to this point of the piece
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

/** The next angle in a sense at which a symmetric piece may lie, the print turned about `about`. */
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

/** The line of the print on which the axis of a symmetric piece lies. */
interface AxisLine {
  /** Of the axis, in the piece's coordinates; of length 1. */
  readonly along: Point;
  /** To the next line on which the axis could lie. [cm] */
  readonly spacing: number;
  /** The axis runs through motifs, which are at the print's origin. */
  readonly isOnMotif: boolean;
}

/** Undefined where the axis is not along mirror lines of the print. */
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
