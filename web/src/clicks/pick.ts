/** Finds the lines and pieces under a point of the sheet. Lengths in cm. */
import {distance, type Point} from '../model/geometry/vectors.js';
import {offSheet} from '../model/geometry/sheet-place.js';
import {goesRound, isNearBox, nearestOn, placeAt, type PlaceOnPath} from './path.js';
import type {Line, PickIndex} from './pick-index.js';
import type {Side} from './sheet.js';

// Snaps a point of a piece to a mark nearby. Lengths in cm.

/** Marks in order of preference, if several are about equally near. */
const marks = ['corner', 'notch', 'midpoint', 'grain'] as const;

export interface Snapped {
  readonly point: Point;
  readonly snapped: (typeof marks)[number] | 'outline' | 'none';
}

interface SnapOptions {
  /** Notches of the piece, in its own coordinates. */
  readonly notches?: readonly Point[];
}

/**
 * Snaps to a mark within `reach`: the most preferred kind wins, and within it the nearest mark.
 * Marks more than half of `reach` further away than the nearest one are ignored. Without a mark the
 * point snaps to the outline, and without an outline within `reach` it stays unchanged. All points
 * are in the piece's own coordinates.
 */
export function snap(
  index: PickIndex,
  piece: number,
  point: Point,
  reach: number,
  {notches = []}: SnapOptions = {},
): Snapped {
  const parts = index.pieces[piece];
  if (!parts) return {point, snapped: 'none'};
  const places: Readonly<Record<(typeof marks)[number], readonly Point[]>> = {
    corner: parts.corners,
    notch: notches,
    midpoint: parts.midpoints,
    grain: index.sheet.pieces[piece]?.grain ?? [],
  };
  const near = marks
    .flatMap((snapped) =>
      places[snapped].map((at) => ({point: at, snapped, distance: distance(at, point)})),
    )
    .filter(({distance}) => distance <= reach);
  const least = Math.min(...near.map(({distance}) => distance));
  const [best] = near
    .filter(({distance}) => distance <= least + reach / 2)
    .sort(
      (one, other) =>
        marks.indexOf(one.snapped) - marks.indexOf(other.snapped) || one.distance - other.distance,
    );
  if (best) return {point: best.point, snapped: best.snapped};
  const place = nearestOn(parts.outline, point);
  return place && place.distance <= reach
    ? {point: place.point, snapped: 'outline'}
    : {point, snapped: 'none'};
}

export interface OnPiece {
  readonly piece: number;
  /** Point in the piece's own coordinates, on the line if the target is one. */
  readonly point: Point;
}

interface SeamTarget extends OnPiece {
  readonly kind: 'seam';
  readonly seam: number;
  readonly side: Side;
  /** Share of the side's length, from 0 at its start to 1 at its end, in sewing order. */
  readonly at: number;
  /** Number of the panel's edge in the file, if the sheet has it. */
  readonly edge: number | undefined;
  readonly distance: number;
}

/** A line without a seam. */
interface EdgeTarget extends OnPiece {
  readonly kind: 'edge';
  /** Number of the panel's edge in the file. */
  readonly edge: number;
  readonly distance: number;
}

/** The inside of a piece without its cut-outs. */
interface PieceTarget extends OnPiece {
  readonly kind: 'piece';
}

export type LineTarget = SeamTarget | EdgeTarget;
export type Target = LineTarget | PieceTarget;

function lineTarget(
  {sheet}: PickIndex,
  piece: number,
  {name, path, along}: Line,
  {point, segment, along: length, distance}: PlaceOnPath,
): LineTarget {
  if (name.kind === 'edge') return {...name, piece, point, distance};
  const outlineEdge = along[segment];
  const edge = outlineEdge === undefined ? undefined : sheet.pieces[piece]?.edges?.[outlineEdge];
  return {...name, piece, point, at: path.length > 0 ? length / path.length : 0, edge, distance};
}

/** Sorts seams before edges at the same distance, such as at a corner. */
const nearestFirst = (one: LineTarget, other: LineTarget): number =>
  one.distance - other.distance || Number(one.kind === 'edge') - Number(other.kind === 'edge');

/**
 * Returns all targets within `reach` of a point of the sheet: lines, the nearest first, then the
 * piece under it.
 */
export function targetsAt(index: PickIndex, point: Point, reach: number): readonly Target[] {
  const lines: LineTarget[] = [];
  const pieces: PieceTarget[] = [];
  for (const [piece, shape] of index.sheet.pieces.entries()) {
    const own = offSheet(shape, point);
    const parts = index.pieces[piece];
    if (!parts || !isNearBox(parts.outline.box, own, reach)) continue;
    for (const line of parts.lines) {
      const place = isNearBox(line.path.box, own, reach) && nearestOn(line.path, own);
      if (place && place.distance <= reach) lines.push(lineTarget(index, piece, line, place));
    }
    if (goesRound(parts.outline, own) && !parts.holes.some((hole) => goesRound(hole, own)))
      pieces.push({kind: 'piece', piece, point: own});
  }
  return [...lines.sort(nearestFirst), ...pieces];
}

/**
 * Returns the targets that a click may equally mean: lines at most `tie` further away than the
 * first.
 */
export function choices(targets: readonly Target[], tie: number): readonly Target[] {
  const [best] = targets;
  if (!best || best.kind === 'piece') return targets;
  return targets.filter(
    (target) => target.kind !== 'piece' && target.distance <= best.distance + tie,
  );
}

/** Returns a side of a seam as if it were clicked in its middle. */
export function seamTarget(index: PickIndex, seam: number, side: Side): SeamTarget | undefined {
  const piece = index.sheet.seams[seam]?.[side].piece ?? -1;
  for (const line of index.pieces[piece]?.lines ?? []) {
    if (line.name.kind !== 'seam' || line.name.seam !== seam || line.name.side !== side) continue;
    const place = placeAt(line.path, line.path.length / 2);
    const target = place && lineTarget(index, piece, line, {...place, distance: 0});
    if (target?.kind === 'seam') return target;
  }
  return undefined;
}
