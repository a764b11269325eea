/** Snaps a point of a piece to a mark nearby. Lengths in cm. */
import {distance, type Point} from '../model/geometry/vectors.js';
import {nearestOn} from './path.js';
import type {PickIndex} from './pick-index.js';

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
