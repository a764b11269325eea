/** Polylines to measure along and to search for the nearest point. Lengths in cm. */
import {between, distance, nearestShare, type Point} from '../model/geometry/vectors.js';
import {boxOf, isInside, type Box} from '../model/geometry/polyline.js';

interface Segment {
  readonly from: Point;
  readonly to: Point;
  /** Path length before the segment. [cm] */
  readonly start: number;
  readonly length: number;
}

/** A polyline; a closed one ends at its first point. */
export interface Path {
  readonly segments: readonly Segment[];
  readonly length: number;
  readonly box: Box;
}

export interface PlaceOnPath {
  readonly point: Point;
  readonly distance: number;
  readonly segment: number;
  /** Path length from the start. [cm] */
  readonly along: number;
}

export function pathThrough(points: readonly Point[]): Path {
  const segments: Segment[] = [];
  let length = 0;
  points.slice(1).forEach((to, k) => {
    const from = points[k] ?? to;
    const step = distance(from, to);
    segments.push({from, to, start: length, length: step});
    length += step;
  });
  return {segments, length, box: boxOf(points)};
}

export const pathRound = (loop: readonly Point[]): Path =>
  pathThrough([...loop, ...loop.slice(0, 1)]);

/** Returns whether a point is in a box or at most `reach` outside it, in x and in y. */
export const isNearBox = ({low, high}: Box, [x, y]: Point, reach: number): boolean =>
  x >= low[0] - reach && x <= high[0] + reach && y >= low[1] - reach && y <= high[1] + reach;

const pointOn = ({from, to}: Segment, share: number): Point =>
  share >= 1 ? to : between(from, to, share); // bit-identical to the next segment's start

/** Returns the first of the points nearest to `p`; undefined if the path has no segments. */
export function nearestOn({segments}: Path, p: Point): PlaceOnPath | undefined {
  let nearest: PlaceOnPath | undefined;
  for (const [k, segment] of segments.entries()) {
    const {from, to, start, length} = segment;
    const share = nearestShare(from, to, p);
    const point = pointOn(segment, share);
    const far = distance(point, p);
    if (nearest && far >= nearest.distance) continue;
    nearest = {point, distance: far, segment: k, along: start + share * length};
  }
  return nearest;
}

/** Returns the place at a length from the path's start; undefined if the path has no segments. */
export function placeAt(
  {segments}: Path,
  along: number,
): Omit<PlaceOnPath, 'distance'> | undefined {
  const after = segments.findIndex(({start, length}) => along <= start + length);
  const k = after < 0 ? segments.length - 1 : after;
  const segment = segments[k];
  if (!segment) return undefined;
  const share = segment.length > 0 ? (along - segment.start) / segment.length : 0;
  return {point: pointOn(segment, share), segment: k, along};
}

/** Returns whether a closed path encloses a point. */
export const goesRound = ({segments}: Path, point: Point): boolean =>
  isInside(
    segments.map(({from}) => from),
    point,
  );
