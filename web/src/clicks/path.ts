/** Lines through points, to measure along and to find the nearest point of. Lengths in cm. */
import {between, distance, nearestShare, type Point} from '../model/geometry.js';
import {boxOf, isInside, type Box} from '../model/polyline.js';

interface Segment {
  readonly from: Point;
  readonly to: Point;
  /** Where on the path it begins. [cm] */
  readonly start: number;
  readonly length: number;
}

/** A closed one ends where it begins. */
export interface Path {
  readonly segments: readonly Segment[];
  readonly length: number;
  readonly box: Box;
}

export interface PlaceOnPath {
  readonly point: Point;
  readonly distance: number;
  readonly segment: number;
  /** From the start of the path. [cm] */
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

/** Whether a point lies in a box or no further than `reach` outside, in x and y. */
export const isNearBox = ({low, high}: Box, [x, y]: Point, reach: number): boolean =>
  x >= low[0] - reach && x <= high[0] + reach && y >= low[1] - reach && y <= high[1] + reach;

const pointOn = ({from, to}: Segment, share: number): Point =>
  share >= 1 ? to : between(from, to, share); // exactly, as the next segment has it

/** The point of a path that is nearest to `p`, of several the first; nothing on a path without segments. */
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

/** The place on a path at a given length from its start; nothing on a path without segments. */
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

/** Whether a closed path goes round a point. */
export const goesRound = ({segments}: Path, point: Point): boolean =>
  isInside(
    segments.map(({from}) => from),
    point,
  );
