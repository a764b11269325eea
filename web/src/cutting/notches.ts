/** Notches of the garment, and additional notches of seams. Lengths in cm. */
import type {Notch, PanelMarks} from '../model/garment/panel-marks.js';
import {distance, dot, leftOf, minus, plus, unit, type Point} from '../model/geometry/vectors.js';
import {nearestOn} from '../model/geometry/nearest.js';
import {atShare, lengthOf} from '../model/geometry/polyline.js';
import type {DraftedFold} from '../model/garment/garment-document.js';
import {carried} from '../model/geometry/triangles.js';
import type {ResultPiece} from '../model/result/result.js';
import {turned} from '../layout/on-body.js';
import {notchMark} from './follow.js';
import {cornerOf, type EdgeKey, type GarmentEdges} from './garment-edges.js';

export interface CutNotch {
  /** Position on the sewn line. */
  readonly at: Point;
  /** Outward unit vector. */
  readonly outward: Point;
  readonly width: number;
  /** Depth of the slit from the cut line. */
  readonly depth: number;
  readonly seam?: number;
}

/** Least length of a seam that gets a notch at its middle. */
const longSeam = 25;
/** Least distance of notches from corners, and of new notches from others. */
const cornerRoom = 2;
const notchRoom = 3;
/** Notches closer than this are one. */
const sameNotch = 0.3;
/** Distance between the two notches of a back piece. */
const pairGap = 1;
/** A seam end with a smaller turn of the outline is a split. [rad] */
const splitTurn = 0.35;
/** Depth of slits as a share of the allowance, and the least allowance that remains. */
const slitShare = 0.4;
const leastLeft = 0.2;
const intoPiece = 0.4;

type Side = 'front' | 'back' | undefined;

/** The side of a piece, from its name or its position on the body. */
function sideOf(marks: PanelMarks | undefined): Side {
  const {label = '', placement} = marks ?? {};
  const said = [/\bfront\b/i, /\bback\b/i].map((word) => word.test(label));
  if (said[0] !== said[1]) return said[0] ? 'front' : 'back';
  const [, , z] = turned([0, 0, 1], placement?.rotation ?? [0, 0, 0]);
  return !placement || Math.abs(z) < 0.5 ? undefined : z > 0 ? 'front' : 'back';
}

const slitDepth = (width: number): number =>
  Math.max(0, Math.min(slitShare * width, width - leastLeft));

/** A notch on an edge, at a share of its length in the direction of the outline. */
function onEdge(garment: GarmentEdges, key: EdgeKey, share: number, width: number): CutNotch {
  const {edge} = garment.edges.get(key) ?? {};
  const {at, along} = atShare(edge?.points ?? [], share);
  const [x, y] = leftOf(along);
  return {
    ...{at, outward: [0 - x, 0 - y], width, depth: slitDepth(width)},
    ...(edge?.seam && {seam: edge.seam.number}),
  };
}

/** Corners of a piece's sewn lines, where notches are useless. */
function cornersOf(garment: GarmentEdges, piece: number): readonly Point[] {
  return (garment.loops[piece] ?? []).flat().flatMap((key) => {
    const {turn} = cornerOf(garment, {key, at: 'start'});
    const [start] = garment.edges.get(key)?.edge.points ?? [];
    return start && Math.abs(turn) > splitTurn ? [start] : [];
  });
}

/** The notches of a piece in the garment. */
function ownNotches(
  garment: GarmentEdges,
  piece: ResultPiece,
  number: number,
  {
    notches,
    widthOf,
  }: {readonly notches: readonly Notch[]; readonly widthOf: (key: EdgeKey) => number},
): CutNotch[] {
  const keys = (garment.loops[number] ?? []).flat();
  const lines = keys.map((key) => garment.edges.get(key)?.edge.points ?? []);
  return notches.flatMap((notch) => {
    const mark = notchMark(piece, notch);
    if (!mark) return [];
    const [best] = lines
      .flatMap((line, k) => projected(mark, line, keys[k]))
      .sort((a, b) => a.miss - b.miss);
    if (!best) return [{...mark, width: 0, depth: 0}];
    const {at, outward, key} = best;
    const seam = garment.edges.get(key)?.edge.seam?.number;
    const width = widthOf(key);
    return [{at, outward, width, depth: slitDepth(width), ...(seam !== undefined && {seam})}];
  });
}

/** Notches where the lines of folds end at the outline. */
function foldNotches(
  garment: GarmentEdges,
  {triangles, rest, shape}: ResultPiece,
  number: number,
  {
    folds,
    widthOf,
  }: {readonly folds: readonly DraftedFold[]; readonly widthOf: (key: EdgeKey) => number},
): CutNotch[] {
  const keys = (garment.loops[number] ?? []).flat();
  const ends = folds.flatMap(({line, to = line}) => [...new Set([...line, ...to])]);
  return ends.flatMap((end) => {
    const at = carried(triangles, rest, shape, end);
    const [best] = keys
      .flatMap((key) =>
        projected({at, outward: [0, 0]}, garment.edges.get(key)?.edge.points ?? [], key),
      )
      .sort((a, b) => a.miss - b.miss);
    if (!best) return [];
    const width = widthOf(best.key);
    return [{at: best.at, outward: best.outward, width, depth: slitDepth(width)}];
  });
}

/** Greatest distance of a notch on a chord of the mesh from the curve of its edge. [cm] */
const chordReach = 0.3;
/** Distance that counts as much as a notch across its edge: at a corner, the direction decides. */
const acrossMiss = 0.1;

/** A mark moved onto an edge, and how far it misses it; none beyond reach. */
function projected(
  mark: Pick<CutNotch, 'at' | 'outward'>,
  line: readonly Point[],
  key: EdgeKey | undefined,
): (Pick<CutNotch, 'at' | 'outward'> & {readonly key: EdgeKey; readonly miss: number})[] {
  const {at, off, step} = nearestOn(line, mark.at, false);
  const [from, to] = [line[step], line[step + 1]];
  if (key === undefined || !from || !to || off > chordReach) return [];
  const [x, y] = leftOf(unit(minus(to, from)));
  const outward: Point = [0 - x, 0 - y];
  return [{at, outward, key, miss: off + acrossMiss * (1 - dot(outward, mark.outward))}];
}

/**
 * The notches of each piece: those of the garment, one at the middle of every long seam, two for a
 * back piece, one at every split of a seam, and one at the end of every fold. Both sides of a seam have them at the same share.
 */
export function garmentNotches(
  garment: GarmentEdges,
  pieces: readonly ResultPiece[],
  marks: readonly PanelMarks[],
  widths: ReadonlyMap<EdgeKey, number>,
): readonly (readonly CutNotch[])[] {
  const widthOf = (key: EdgeKey): number => widths.get(key) ?? 0;
  const found = pieces.map((piece, k) =>
    ownNotches(garment, piece, k, {notches: marks[k]?.notches ?? [], widthOf}),
  );
  const corners = pieces.map((_, k) => cornersOf(garment, k));
  const isFree = (piece: number, {at}: CutNotch): boolean =>
    (corners[piece] ?? []).every((corner) => distance(corner, at) >= cornerRoom) &&
    (found[piece] ?? []).every((other) => distance(other.at, at) >= notchRoom);

  pieces.forEach((piece, k) => {
    const folds = marks[k]?.drafted?.folds ?? [];
    for (const notch of foldNotches(garment, piece, k, {folds, widthOf}))
      if (!found[k]?.some(({at}) => distance(at, notch.at) < sameNotch)) found[k]?.push(notch);
  });
  for (const [a, b] of seamSides(garment)) {
    const sides = [a, b].map((key) => ({
      ...{key, piece: garment.edges.get(key)?.piece ?? 0},
      isReversed: garment.edges.get(key)?.edge.seam?.isReversed ?? false,
      length: lengthOf(garment.edges.get(key)?.edge.points ?? []),
    }));
    const longest = Math.max(...sides.map(({length}) => length));
    const on = sides.map(({piece}) => sideOf(marks[piece]));
    const isBack = on.includes('back') && !on.includes('front');
    const half = isBack ? pairGap / 2 / longest : 0;
    const shares = longest > longSeam ? (isBack ? [0.5 - half, 0.5 + half] : [0.5]) : [];
    const added = sides.map(({key, piece, isReversed}) =>
      shares.map((share) => ({
        piece,
        notch: onEdge(garment, key, isReversed ? 1 - share : share, widthOf(key)),
      })),
    );
    // both sides or none
    if (added.flat().every(({piece, notch}) => isFree(piece, notch)))
      for (const {piece, notch} of added.flat()) found[piece]?.push(notch);
  }
  for (const [key, {edge, piece}] of garment.edges) {
    const {other, turn} = cornerOf(garment, {key, at: 'start'});
    const isSplit = edge.seam && garment.edges.get(other)?.edge.seam && other !== key;
    const notch = onEdge(garment, key, 0, widthOf(key));
    if (isSplit && Math.abs(turn) < splitTurn && isFree(piece, notch)) found[piece]?.push(notch);
  }
  return found;
}

/** The two edges of every seam. */
function seamSides({edges}: GarmentEdges): readonly (readonly [EdgeKey, EdgeKey])[] {
  const first = new Map<number, EdgeKey>();
  return [...edges].flatMap(([key, {edge}]) => {
    if (!edge.seam) return [];
    const other = first.get(edge.seam.number);
    first.set(edge.seam.number, key);
    return other === undefined ? [] : [[other, key] as const];
  });
}

/** The slit of a notch; without an allowance to cut into, a line into the piece. */
export function slitOf({at, outward, width, depth}: CutNotch): readonly [Point, Point] {
  const edge = plus(at, outward, width);
  return [edge, plus(edge, outward, -(depth || intoPiece))];
}
