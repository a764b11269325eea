/** What lies under a point of the sheet. Lengths in cm. */
import type {Point} from '../model/geometry.js';
import {offSheet} from '../model/sheet-place.js';
import {goesRound, isNearBox, nearestOn, placeAt, type PlaceOnPath} from './path.js';
import type {Line, PickIndex} from './pick-index.js';
import type {Side} from './sheet.js';

export interface OnPiece {
  readonly piece: number;
  /** Where, in the piece's own coordinates: on the line, if it is one. */
  readonly point: Point;
}

interface SeamTarget extends OnPiece {
  readonly kind: 'seam';
  readonly seam: number;
  readonly side: Side;
  /** From 0 at the start of the side to 1 at its end, in sewing order and by length. */
  readonly at: number;
  /** The panel's edge in the file, where the sheet knows it. */
  readonly edge: number | undefined;
  readonly distance: number;
}

/** A line that is not sewn. */
interface EdgeTarget extends OnPiece {
  readonly kind: 'edge';
  /** The panel's edge in the file. */
  readonly edge: number;
  readonly distance: number;
}

/** The inside of a piece, which its cut-outs do not belong to. */
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

/** Seams go before edges at the same distance: at a corner, say. */
const nearestFirst = (one: LineTarget, other: LineTarget): number =>
  one.distance - other.distance || Number(one.kind === 'edge') - Number(other.kind === 'edge');

/** All that lies within `reach` of a point of the sheet: lines, nearest first, then the piece under it. */
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

/** Those that a click may have meant just as well as the first: lines at most `tie` further away. */
export function choices(targets: readonly Target[], tie: number): readonly Target[] {
  const [best] = targets;
  if (!best || best.kind === 'piece') return targets;
  return targets.filter(
    (target) => target.kind !== 'piece' && target.distance <= best.distance + tie,
  );
}

/** A side of a seam as if it had been clicked in its middle. */
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
