/**
 * Converts the chosen part of a drawing to a garment: in centimetres, with outlines
 * counter-clockwise and no piece mirrored.
 */
import type {GrainChoice} from '../model/garment/grain.js';
import {mappedFold} from '../model/garment/folds.js';
import {withLineNames} from '../model/garment/line-names.js';
import {divideAtFolds} from '../model/garment/pleated-edges.js';
import type {Drawing, DrawnPiece, Run} from '../model/garment/imported-drawing.js';
import type {
  DraftedEdge,
  DraftedNotch,
  EdgeOfPiece,
  FileUnit,
  GarmentDocument,
  GarmentPiece,
} from '../model/garment/garment-document.js';
import {
  between,
  cross,
  distance,
  dot,
  minus,
  radians,
  type Point,
} from '../model/geometry/vectors.js';
import {atShare, signedArea} from '../model/geometry/polyline.js';
import type {Symmetry} from '../model/garment/symmetries.js';
import {endOf, isLine, mapped, reversedLoop, tracedLoop, tracedRun} from './base/bezier.js';
import {crossing} from './base/crossings.js';
import {foldsWithin} from './base/fold-lines.js';
import {nearestOn} from '../model/geometry/nearest.js';
import {cmPer} from './base/units.js';
import {unfolded} from './unfold.js';

/** Greatest deviation of traced lines from their curves. [cm] */
const traceTolerance = 0.002;

/** Greatest distance of control points from a straight line. [cm] */
const straightTolerance = 1e-4;

/** Greatest distance of a notch from its edge. [cm] */
const notchReach = 3;

/** A grain line with a smaller rise is horizontal, and points to the right in all pieces. [rad] */
const sideways = radians(20);

/** Greatest allowance of an edge; a cut line farther away is none of the piece. [cm] */
const widest = 12;

/** Smallest area of a printed piece. [cm2] */
const smallest = 4;

/** The choice for one piece: use it, and cut its mirror image, too. */
export interface PieceChoice {
  readonly take: boolean;
  readonly cut: 'once' | 'pair';
  /** Indices of the piece's holes that are lines drawn on it instead. Default: none. */
  readonly lines?: readonly number[];
}

export interface Choices {
  readonly unit: FileUnit;
  /** One per piece of the drawing. */
  readonly pieces: readonly PieceChoice[];
}

/** The default choices for a drawing. */
export interface DefaultChoices extends Choices {
  /** One sentence for every omitted piece. */
  readonly notes: readonly string[];
}

const unprinted = /lining|fusible|fusing|interfacing/i;

export function defaultChoices(drawing: Drawing): DefaultChoices {
  const {unit} = drawing.unit;
  const notes: string[] = [];
  const pieces = drawing.pieces.map((piece): PieceChoice => {
    const reason = reasonToLeave(piece, cmPer(unit));
    if (reason !== undefined) notes.push(`Piece '${piece.name}' is left out: ${reason}.`);
    const inCm = scaledPiece(piece, cmPer(unit));
    if (piece.cut && !cutLineOf(unfolded(inCm).piece)) {
      notes.push(
        `The cut line of piece '${piece.name}' is left out, since it lies more than ${widest} cm from an edge.`,
      );
    }
    if (piece.fold && !unfolded(inCm).axis) {
      notes.push(
        `The fold of piece '${piece.name}' is not on its outline, so that it is taken as a whole; draw the fold along an edge to have it unfolded.`,
      );
    }
    return {take: reason === undefined, cut: isPair(piece) ? 'pair' : 'once'};
  });
  return {unit, pieces, notes};
}

function reasonToLeave(piece: DrawnPiece, scale: number): string | undefined {
  const {sewn, material = '', doubt} = piece;
  if (doubt !== undefined) return doubt;
  const line = tracedLoop(sewn, traceTolerance / scale);
  const area = Math.abs(signedArea(line)) * scale * scale;
  if (area < smallest) return `it has ${area.toFixed(1)} cm2`;
  const [x, y] = crossing(line) ?? [];
  if (x !== undefined && y !== undefined) {
    return `its outline crosses itself near x ${(x * scale).toFixed(1)} cm, y ${(y * scale).toFixed(1)} cm`;
  }
  return unprinted.test(material) ? `its material is ${material}` : undefined;
}

/**
 * Returns whether a piece is cut as drawn and mirrored; an unfolded piece is its own mirror image.
 */
const isPair = ({quantity: {asDrawn, mirrored}, fold}: DrawnPiece): boolean =>
  !fold && asDrawn > 0 && mirrored > 0;

/**
 * The garment of a drawing. Half pieces are unfolded and keep their axis as a symmetry; the mirror
 * image of a pair is a separate piece.
 */
export function garmentOf(drawing: Drawing, {unit, pieces: choices}: Choices): GarmentDocument {
  const names = new Set<string>();
  const pieces: GarmentPiece[] = [];
  const symmetries: Symmetry[] = [];
  const places = new Map<number, Placed>();
  drawing.pieces.forEach((drawn, number) => {
    const {take, cut, lines = []} = choices[number] ?? {take: true, cut: 'once'};
    if (!take) return;
    const {asDrawn, mirrored} = drawn.quantity;
    const made = pieceOf(withLines(drawn, lines, unit), uniqueName(drawn.name, names), cmPer(unit));
    if (asDrawn === 0 && mirrored > 0 && !made.axis && cut === 'once') {
      pieces.push(mirrorImage(made.piece, made.piece.name));
      return;
    }
    places.set(number, {...made, number: pieces.length});
    pieces.push(made.piece);
    if (made.axis) symmetries.push({kind: 'piece', piece: made.piece.name, axis: made.axis});
    if (cut !== 'pair') return;
    const image = mirrorImage(made.piece, uniqueName(drawn.name, names));
    const twin = isPair(drawn) ? withQuantity(image, mirrored) : image;
    pieces.push(twin);
    symmetries.push({kind: 'pair', pieces: [made.piece.name, twin.name]});
  });
  const end = ({piece, run}: {readonly piece: number; readonly run: number}): EdgeOfPiece[] => {
    const placed = places.get(piece);
    const edge = placed?.edges[run];
    return placed && edge !== undefined ? [{piece: placed.number, edge}] : [];
  };
  const seams = drawing.seams.flatMap(({a, b, sameDirection}) => {
    const [[from], [to]] = [end(a), end(b)];
    return from && to ? [{a: from, b: to, sameDirection, weight: 1, matched: true}] : [];
  });
  return divideAtFolds({
    ...{pieces, seams, matches: [], symmetries, questions: []},
    ...(drawing.title !== undefined && {title: drawing.title}),
    ...(drawing.size !== undefined && {size: drawing.size}),
  }).document;
}

/** The piece with some of its holes as lines drawn on it. */
function withLines(drawn: DrawnPiece, lines: readonly number[], unit: FileUnit): DrawnPiece {
  if (lines.length === 0) return drawn;
  const drawnOn = drawn.holes.filter((_, k) => lines.includes(k));
  const closed = drawnOn.map((hole) => {
    const line = tracedLoop(hole, traceTolerance / cmPer(unit));
    return [...line, ...line.slice(0, 1)];
  });
  return {
    ...drawn,
    holes: drawn.holes.filter((_, k) => !lines.includes(k)),
    internalLines: [...drawn.internalLines, ...closed],
  };
}

function withQuantity({quantity, ...piece}: GarmentPiece, count: number): GarmentPiece {
  return quantity === undefined && count <= 1
    ? piece
    : {...piece, ...(count > 1 && {quantity: count})};
}

/** A unique name such as "Sleeve" or "Sleeve 2", with a limited length for messages. */
function uniqueName(drawn: string, taken: Set<string>): string {
  const stem =
    drawn
      .replaceAll(/\p{Cc}/gu, ' ')
      .trim()
      .slice(0, 80) || 'piece';
  let name = stem;
  for (let k = 2; taken.has(name); k++) name = `${stem} ${k}`;
  taken.add(name);
  return name;
}

/**
 * A single piece in the format of a garment.
 * @param scale cm per unit of the drawing
 */
export const drawnPieceInCm = (drawn: DrawnPiece, scale: number): GarmentPiece =>
  pieceOf(drawn, drawn.name, scale).piece;

interface Made {
  readonly piece: GarmentPiece;
  /** Edge index per drawn run. */
  readonly edges: readonly number[];
  readonly axis?: readonly [Point, Point];
}

interface Placed extends Made {
  readonly number: number;
}

function pieceOf(drawn: DrawnPiece, name: string, scale: number): Made {
  const inCm = scaledPiece(drawn, scale);
  const {piece: whole, axis} = unfolded(inCm);
  const isClockwise = signedArea(tracedLoop(whole.sewn, traceTolerance)) < 0;
  const runs = isClockwise ? reversedLoop(whole.sewn) : whole.sewn;
  const {
    quantity: {asDrawn, mirrored},
    grain,
  } = whole;
  const cut = cutLineOf(whole);
  const count = isPair(drawn) ? asDrawn : asDrawn + mirrored;
  const last = runs.length - 1;
  return {
    piece: {
      ...{name, mirroredFromInput: false},
      outline: runs.map((run) => withAllowance(run, cut)),
      holes: whole.holes.map((hole) => turnedClockwise(hole).map(edgeOf)),
      internalLines: whole.internalLines,
      ...withLineNames(whole.lineNames ?? []),
      ...(cut && {cutLine: cut}),
      notches: notchesOf(whole, runs),
      ...(grain && {grain: {line: upwards(grain), lock: 'on'}}),
      ...(whole.grains && {
        grains: whole.grains.map((one) => ({...one, line: upwards(one.line)})),
      }),
      ...(count > 1 && {quantity: count}),
      ...(whole.size !== undefined && {size: whole.size}),
      ...(whole.material !== undefined && {material: whole.material}),
      ...(whole.folds && {folds: foldsWithin(whole.folds, tracedLoop(whole.sewn, traceTolerance))}),
      ...(whole.drillHoles.length > 0 && {drillHoles: whole.drillHoles}),
    },
    edges: runs.map((_, k) => (isClockwise ? last - k : k)),
    ...(axis && {axis}),
  };
}

/** Orients a grain line upwards, since grain lines in such files have no defined direction. */
function upwards([from, to]: readonly [Point, Point]): readonly [Point, Point] {
  return dot(minus(to, from), [Math.sin(sideways), Math.cos(sideways)]) < 0
    ? [to, from]
    : [from, to];
}

function scaledPiece(piece: DrawnPiece, scale: number): DrawnPiece {
  const at = ([x, y]: Point): Point => [x * scale, y * scale];
  const line = ([from, to]: readonly [Point, Point]) => [at(from), at(to)] as const;
  const loop = (runs: readonly Run[]): Run[] => runs.map((run) => mapped(run, at));
  const {
    sewn,
    cut,
    holes,
    notches,
    grain,
    grains,
    fold,
    folds,
    internalLines,
    drillHoles,
    ...rest
  } = piece;
  return {
    ...rest,
    sewn: loop(sewn),
    ...(cut && {cut: loop(cut)}),
    holes: holes.map(loop),
    notches: notches.map(({towards, ...notch}) => ({
      ...notch,
      at: at(notch.at),
      ...(towards && {towards: at(towards)}),
    })),
    ...(grain && {grain: line(grain)}),
    ...(grains && {grains: grains.map((one) => ({...one, line: line(one.line)}))}),
    ...(fold && {fold: line(fold)}),
    ...(folds && {folds: folds.map((one) => mappedFold(one, at))}),
    internalLines: internalLines.map((points) => points.map(at)),
    drillHoles: drillHoles.map(at),
  };
}

const turnedClockwise = (loop: readonly Run[]): readonly Run[] =>
  signedArea(tracedLoop(loop, traceTolerance)) > 0 ? reversedLoop(loop) : loop;

function edgeOf(run: Run): DraftedEdge {
  if (isLine(run, straightTolerance)) return {points: [run.start, endOf(run)]};
  const [first, ...rest] = run.cubics.flat();
  return {points: [run.start, first ?? run.start, ...rest]};
}

/** The points of a piece's cut line; undefined if it has none, or one too far away. */
function cutLineOf({sewn, cut}: DrawnPiece): readonly Point[] | undefined {
  const line = cut && tracedLoop(cut, traceTolerance);
  return line && sewn.every((run) => widthOf(run, line) <= widest) ? line : undefined;
}

/** The allowance of an edge: the median width, since corners have other widths. [cm] */
function widthOf(run: Run, cut: readonly Point[]): number {
  const line = tracedRun(run, traceTolerance);
  const widths = Array.from({length: 15}, (_, k) => atShare(line, (k + 0.5) / 15).at)
    .map((at) => nearestOn(cut, at, true).off)
    .sort((a, b) => a - b);
  return widths[7] ?? 0;
}

function withAllowance(run: Run, cut: readonly Point[] | undefined): DraftedEdge {
  const edge = edgeOf(run);
  return cut ? {...edge, allowance: {width: Number(widthOf(run, cut).toFixed(3))}} : edge;
}

/** Greatest way along a notch to its edge, as a multiple of the shortest one. */
const slantedWay = 1.2;

/**
 * Assigns each notch to its nearest edge within reach. A notch on the cut line meets the edge along
 * its own direction, if the file states one that leads there.
 */
function notchesOf({notches}: DrawnPiece, runs: readonly Run[]): DraftedNotch[] {
  const lines = runs.map((run) => measured(tracedRun(run, traceTolerance)));
  const first = (found: readonly OnEdge[]): OnEdge | undefined =>
    [...found].sort((a, b) => a.off - b.off)[0];
  return notches.flatMap(({at, towards}): DraftedNotch[] => {
    const best = first(lines.map((line, edge) => ({edge, ...onLine(line, at)})));
    if (!best || best.off > notchReach) return [];
    const hit =
      towards &&
      first(lines.flatMap((line, edge) => hits(line, at, towards).map((on) => ({edge, ...on}))));
    const {edge, share} = hit && hit.off <= slantedWay * best.off ? hit : best;
    return [{edge, at: share}];
  });
}

interface Measured {
  readonly points: readonly Point[];
  /** Length from the start to each point. */
  readonly lengths: readonly number[];
}

function measured(points: readonly Point[]): Measured {
  let length = 0;
  return {
    points,
    lengths: points.map(([x, y], k) => {
      const [px, py] = points[k - 1] ?? [x, y];
      return (length += Math.hypot(x - px, y - py));
    }),
  };
}

/** A point of a line: its share of the length, and its distance from another point. */
interface OnLine {
  readonly off: number;
  readonly share: number;
}

interface OnEdge extends OnLine {
  readonly edge: number;
}

const shareOf = ({points, lengths}: Measured, step: number, at: Point): number =>
  ((lengths[step] ?? 0) + distance(at, points[step] ?? at)) / (lengths.at(-1) ?? 1);

function onLine(line: Measured, point: Point): OnLine {
  const {at, off, step} = nearestOn(line.points, point, false);
  return {off, share: shareOf(line, step, at)};
}

/** The crossings of a straight line through two points with another line. */
function hits(line: Measured, from: Point, to: Point): OnLine[] {
  const way = minus(to, from);
  const sides = line.points.map((p) => cross(way, minus(p, from)));
  return line.points.slice(1).flatMap((end, step): OnLine[] => {
    const [start = end, before = 0, after = 0] = [line.points[step], sides[step], sides[step + 1]];
    if (before === after || before < 0 === after < 0) return [];
    const at = between(start, end, before / (before - after));
    return [{off: distance(at, from), share: shareOf(line, step, at)}];
  });
}

const mirror = ([x, y]: Point): Point => [0 - x, y];
const mirrored = ([from, to]: readonly [Point, Point]) => [mirror(from), mirror(to)] as const;

const mirroredGrain = ({line, angleDeg, ...rest}: GrainChoice): GrainChoice => ({
  ...rest,
  ...(line && {line: mirrored(line)}),
  ...(angleDeg !== undefined && {angleDeg: 180 - angleDeg}),
});

/** The piece with x reversed; its outline is reversed, too, to stay counter-clockwise. */
function mirrorImage(piece: GarmentPiece, name: string): GarmentPiece {
  const {outline, holes, internalLines, cutLine, notches = [], folds, grain, drillHoles} = piece;
  const loop = (edges: readonly DraftedEdge[]): DraftedEdge[] =>
    edges
      .map((edge) => ({...edge, points: edge.points.map(mirror).reverse() as [Point, Point]}))
      .reverse();
  const last = outline.length - 1;
  return {
    ...piece,
    name,
    outline: loop(outline),
    holes: holes.map(loop),
    internalLines: internalLines.map((line) => line.map(mirror)),
    ...(cutLine && {cutLine: cutLine.map(mirror)}),
    notches: notches.map(({edge, at}) => ({edge: last - edge, at: 1 - at})),
    ...(folds && {folds: folds.map((fold) => mappedFold(fold, mirror))}),
    ...(drillHoles && {drillHoles: drillHoles.map(mirror)}),
    ...(grain?.line && {grain: {...grain, line: mirrored(grain.line)}}),
    ...(piece.grains && {
      grains: piece.grains.map(mirroredGrain),
    }),
  };
}
