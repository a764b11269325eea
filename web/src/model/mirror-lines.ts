/** Where a symmetric piece may lie on a print: with its axis on one of the print's mirror lines. */
import {cross, dot, minus, rotated, type Alignment, type Point} from './geometry.js';
import {determinant, printElements, reducedBasis, type PlaneMap, type Repeat} from './wallpaper.js';

/** Parallel mirror lines of a print, at equal distances; glide lines are none. Points of the print. */
export interface MirrorLines {
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

const normalOf = ([x, y]: Point): Point => [0 - y, x];

/** To (-pi, pi]. */
export function wrapped(angle: number): number {
  const turn = angle - 2 * Math.PI * Math.round(angle / (2 * Math.PI));
  return turn <= -Math.PI ? turn + 2 * Math.PI : turn;
}

/** The point of the print that lies under a point of a piece. */
const printPoint = ({angle, translation}: Alignment, [x, y]: Point): Point =>
  rotated(minus([x, y], translation), -angle);

/** The alignment of this angle under which a point of the piece lies on a point of the print. */
function lyingOn(angle: number, [x, y]: Point, print: Point): Alignment {
  const [dx, dy] = rotated(print, angle);
  return {angle: wrapped(angle), translation: [x - dx, y - dy]};
}

/** Lattice vectors around the origin. */
function latticeVectors({w1, w2}: Repeat): readonly Point[] {
  const [a, b] = reducedBasis(w1, w2);
  const steps = Array.from({length: 2 * reach + 1}, (_, k) => k - reach);
  return steps.flatMap((i) => steps.map((j): Point => [i * a[0] + j * b[0], i * a[1] + j * b[1]]));
}

/** What is left of a vector when whole repeats are taken away. */
export function reduced({w1, w2}: Repeat, [x, y]: Point): Point {
  const [a, b] = reducedBasis(w1, w2);
  const d = a[0] * b[1] - a[1] * b[0];
  const i = Math.round((x * b[1] - y * b[0]) / d);
  const j = Math.round((a[0] * y - a[1] * x) / d);
  return [x - i * a[0] - j * b[0], y - i * a[1] - j * b[1]];
}

export function mirrorLines(repeat: Repeat): readonly MirrorLines[] {
  const vectors = latticeVectors(repeat);
  const [a, b] = reducedBasis(repeat.w1, repeat.w2);
  const near = tolerance * Math.hypot(...a);
  const area = Math.abs(cross(a, b));
  const shortest = (along: Point): number =>
    Math.min(
      ...vectors
        .filter((vector) => Math.abs(dot(vector, normalOf(along))) < near)
        .map((vector) => Math.abs(dot(vector, along)))
        .filter((length) => length > near),
    );
  return mirrored(repeat).flatMap(({xx, xy, yx, yy, shift}): MirrorLines[] => {
    const angle = Math.atan2(yx + xy, xx - yy) / 2;
    const along: Point = [Math.cos(angle), Math.sin(angle)];
    const normal = normalOf(along);
    const rest = reduced(repeat, shift);
    // a mirror has no part along its axis; else it is a glide, with every lattice vector
    const whole = vectors
      .map(([x, y]): Point => [rest[0] + x, rest[1] + y])
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
export interface MirrorPlace extends MirrorLines {
  readonly angle: number;
}

/** Where the axis of a reflection p' = R F p + t runs. [rad] */
const axisAngle = (map: Alignment): number => (map.angle - Math.PI) / 2;

/** The point of the axis of p' = R F p + t that is nearest to a point. */
export function footOnAxis(map: Alignment, [x, y]: Point): Point {
  const along: Point = [Math.cos(axisAngle(map)), Math.sin(axisAngle(map))];
  const [ax, ay] = [map.translation[0] / 2, map.translation[1] / 2];
  const way = dot([x - ax, y - ay], along);
  return [ax + way * along[0], ay + way * along[1]];
}

/** All ways for a piece with this reflection to lie; none on a print without mirrors. */
export function mirrorPlaces(
  repeat: Repeat,
  map: Alignment,
  rule?: AngleRule,
): readonly MirrorPlace[] {
  return mirrorLines(repeat)
    .flatMap((lines) => [lines, {...lines, ...turnedRound(lines)}])
    .map((lines) => ({
      ...lines,
      angle: wrapped(axisAngle(map) - Math.atan2(lines.along[1], lines.along[0])),
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
  const normal = normalOf(along);
  const off = dot(point, normal) - offset;
  const shift = off - spacing * Math.round(off / spacing);
  return {at: [point[0] - shift * normal[0], point[1] - shift * normal[1]], shift: Math.abs(shift)};
}

/**
 * The alignment nearest to `wanted` (least turn, then least shift across the axis) that puts the axis of a
 * symmetric piece on a mirror line of the print. Undefined where there is none.
 * @param map the piece's own reflection, p' = R F p + t
 * @param about turns are about the axis point nearest to this point of the piece
 */
export function nearestMirrored(
  repeat: Repeat,
  map: Alignment,
  wanted: Alignment,
  about: Point,
  rule?: AngleRule,
): Alignment | undefined {
  const foot = footOnAxis(map, about);
  const point = printPoint(wanted, foot);
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
  map: Alignment,
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
  const wanted = lyingOn(next, foot, printPoint(from, foot));
  return nearestMirrored(repeat, map, wanted, about);
}

/** The line of the print on which the axis of a symmetric piece lies. */
export interface AxisLine {
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
  map: Alignment,
  alignment: Alignment,
): AxisLine | undefined {
  const axis = axisAngle(map);
  const angle = axis - alignment.angle;
  const lines = mirrorLines(repeat).find(
    ({along}) => Math.abs(Math.sin(Math.atan2(along[1], along[0]) - angle)) < 1e-6,
  );
  if (!lines) return undefined;
  const {spacing, motifs} = lines;
  const off = dot(printPoint(alignment, footOnAxis(map, [0, 0])), normalOf(lines.along)) / motifs;
  return {
    along: [Math.cos(axis), Math.sin(axis)],
    spacing,
    isOnMotif: Math.abs(off - Math.round(off)) * motifs < 1e-3,
  };
}
