/**
 * Lines of folds from places on a piece, in the coordinates of the face-up piece as drafted. Lengths
 * in cm.
 */
import {edgeLine, exactSteps} from '../model/garment/edge-curve.js';
import {hidesFabric} from '../model/garment/folds.js';
import type {DraftedFold, FoldKind, GarmentPiece} from '../model/garment/garment-document.js';
import {nearestOn} from '../model/geometry/nearest.js';
import {boxOf, linesInside} from '../model/geometry/polyline.js';
import {
  cross,
  distance,
  dot,
  leftOf,
  middle,
  minus,
  plus,
  unit,
  type Point,
} from '../model/geometry/vectors.js';

type Ends = readonly [Point, Point];
type Shape = Pick<GarmentPiece, 'outline' | 'holes' | 'folds' | 'grain'>;

/** A place of a fold line: a point, or a line drawn inside the piece. */
export interface FoldPlace {
  readonly point: Point;
  readonly line?: Ends;
}

/** Reasons why two places give no fold. */
export type FoldRefusal = 'near' | 'outside' | 'crossing';

/** Least fabric in a pleat, and least length of a line. */
const narrowest = 0.2;
const shortest = 0.5;
/** Greatest distance of a point on the outline from it. */
const onOutline = 0.1;
/** Greatest angle to a direction that a fold takes instead, as a sine. */
const nearly = 0.2;
/** Lines drawn inside a piece are straight within this share of their length. */
const straight = 0.01;

const loopsOf = ({outline, holes}: Shape): readonly (readonly Point[])[] =>
  [outline, ...holes].map((loop) => loop.flatMap((edge) => edgeLine(edge, exactSteps).slice(1)));

/** The stretch of a line through a point that is inside the piece and nearest to the point. */
function stretchAt(
  loops: readonly (readonly Point[])[],
  at: Point,
  along: Point,
): Ends | undefined {
  const {low, high} = boxOf(loops[0] ?? []);
  const far = distance(low, high) + distance(low, at) + 1;
  const off = (ends: Ends): number => nearestOn(ends, at, false).off;
  const [nearest] = [...linesInside(loops, plus(at, along, -far), plus(at, along, far))].sort(
    (one, other) => off(one) - off(other),
  );
  return nearest && off(nearest) < 1 ? nearest : undefined;
}

/**
 * Turns a direction to that of another pleat or of the grain, or across the grain, if it is near:
 * pleats of a piece are parallel, although hems and waists are curved.
 */
function straightened({folds = [], grain}: Shape, way: Point): Point {
  const ways = folds.filter(hidesFabric).map(({line: [from, to]}) => minus(to, from));
  const up = grain?.line ? minus(grain.line[1], grain.line[0]) : ([0, 1] as const);
  const near = [...ways, up, leftOf(up)]
    .map(unit)
    .find((one) => Math.abs(cross(one, way)) < nearly);
  if (!near) return way;
  return dot(near, way) > 0 ? near : [0 - near[0], 0 - near[1]];
}

/** The line at a right angle to the outline through a point on it or inside the piece. */
function guideAt(piece: Shape, point: Point): Ends | undefined {
  const loops = loopsOf(piece);
  const [outline = []] = loops;
  const foot = nearestOn(outline, point, true);
  const count = outline.length;
  const inwards = (step: number): Point => {
    const [from, to] = [outline[step % count] ?? point, outline[(step + 1) % count] ?? point];
    return leftOf(unit(minus(to, from)));
  };
  // a corner belongs to both of its edges
  const isAt = (step: number): boolean =>
    distance(outline[step % count] ?? foot.at, foot.at) < onOutline;
  const steps = [
    foot.step,
    ...(isAt(foot.step) ? [foot.step + count - 1] : []),
    ...(isAt(foot.step + 1) ? [foot.step + 1] : []),
  ];
  const ways = foot.off > onOutline ? [unit(minus(point, foot.at))] : steps.map(inwards);
  const lines = ways.flatMap((normal): Ends[] => {
    const way = straightened(piece, normal);
    const ends = stretchAt(loops, plus(foot.at, way, 2 * onOutline), way);
    return ends && distance(ends[0], foot.at) < 1 ? [[foot.at, ends[1]]] : [];
  });
  return lines.sort((one, other) => distance(...other) - distance(...one))[0];
}

/** A line drawn inside the piece near a point, with its start nearest to the outline. */
export function innerLineAt(piece: GarmentPiece, point: Point, reach: number): Ends | undefined {
  const [outline = []] = loopsOf(piece);
  const off = (line: readonly Point[]): number => nearestOn(line, point, false).off;
  const [nearest] = piece.internalLines
    .filter((line) => off(line) < reach && isStraight(line))
    .sort((one, other) => off(one) - off(other));
  const [from, to] = [nearest?.[0], nearest?.at(-1)];
  if (!from || !to) return undefined;
  const depth = (p: Point): number => nearestOn(outline, p, true).off;
  return depth(from) <= depth(to) ? [from, to] : [to, from];
}

function isStraight(line: readonly Point[]): boolean {
  const [from, to] = [line[0], line.at(-1)];
  if (!from || !to || distance(from, to) < shortest) return false;
  const along = unit(minus(to, from));
  return line.every((p) => Math.abs(cross(along, minus(p, from))) < straight * distance(from, to));
}

/** The first line of a fold at a place; undefined if the place gives none. */
export const firstLine = (piece: Shape, {point, line}: FoldPlace): Ends | undefined =>
  line ?? guideAt(piece, point);

/** The line from its start as far as a length. */
function shortened(line: Ends, lengthCm: number | undefined): Ends {
  const [from, to] = line;
  const whole = distance(from, to);
  if (lengthCm === undefined || lengthCm >= whole) return line;
  return [from, plus(from, unit(minus(to, from)), lengthCm)];
}

/** A pleat with as much fabric between its lines; its second line moves parallel to the first. */
export function withUptake(piece: Shape, fold: DraftedFold, uptakeCm: number): DraftedFold {
  const {line, to} = fold;
  if (!to) return fold;
  const along = unit(minus(line[1], line[0]));
  const side = Math.sign(cross(along, minus(middle(...to), line[0])));
  const beside = plus(line[0], leftOf(along), side * uptakeCm);
  const whole = stretchAt(loopsOf(piece), plus(beside, along, distance(...line) / 2), along);
  const moved = whole && shortened(whole, isPartial(piece, fold) ? distance(...line) : undefined);
  return moved ? {...fold, to: moved} : fold;
}

/** Returns whether a fold ends inside its piece. */
function isPartial(piece: Shape, {line}: Pick<DraftedFold, 'line'>): boolean {
  const [outline = []] = loopsOf(piece);
  return nearestOn(outline, line[1], true).off > 2 * narrowest;
}

/** The fold with lines of another length from their starts; undefined: to the other side. */
export function withLength(
  piece: Shape,
  fold: DraftedFold,
  lengthCm: number | undefined,
): DraftedFold {
  const loops = loopsOf(piece);
  const cut = ([from, to]: Ends): Ends => {
    const along = unit(minus(to, from));
    const [, end] = stretchAt(loops, plus(from, along, narrowest), along) ?? [from, to];
    return shortened([from, end], lengthCm);
  };
  return {...fold, line: cut(fold.line), ...(fold.to && {to: cut(fold.to)})};
}

/** Fabric between the lines of a pleat; 0 for a crease. */
export const uptakeOf = ({line, to}: Pick<DraftedFold, 'line' | 'to'>): number =>
  to ? Math.abs(cross(unit(minus(line[1], line[0])), minus(middle(...to), line[0]))) : 0;

/** A crease runs from place to place, or along a line of the piece. */
function creaseOf(kind: FoldKind, first: FoldPlace, second: FoldPlace): DraftedFold | FoldRefusal {
  const line: Ends = first.line ?? [first.point, second.point];
  return distance(...line) < shortest ? 'near' : {kind, line};
}

/**
 * The fold at two places. The lines of a pleat run at a right angle from the edge to the other side
 * of the piece, or along lines drawn there; a crease joins its places.
 * @param lengthCm of a tuck from the edge; undefined: to the other side
 */
export function foldAt(
  piece: Shape,
  kind: FoldKind,
  [first, second]: readonly [FoldPlace, FoldPlace],
  lengthCm?: number,
): DraftedFold | FoldRefusal {
  if (!hidesFabric({kind})) return creaseOf(kind, first, second);
  const line = firstLine(piece, first);
  if (!line) return 'outside';
  const along = unit(minus(line[1], line[0]));
  const beside = second.line ?? stretchAt(loopsOf(piece), second.point, along);
  if (!beside) return 'outside';
  const isReversed = dot(along, minus(beside[1], beside[0])) < 0;
  const to: Ends = isReversed ? [beside[1], beside[0]] : beside;
  const sides = to.map((p) => cross(along, minus(p, line[0])));
  if (sides.some((side) => Math.abs(side) < narrowest)) return 'near';
  if (Math.sign(sides[0] ?? 0) !== Math.sign(sides[1] ?? 0)) return 'crossing';
  const cm = kind === 'tuck' ? lengthCm : undefined;
  return {kind, line: shortened(line, cm), to: shortened(to, cm)};
}
