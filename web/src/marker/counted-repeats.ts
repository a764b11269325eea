/** Position on the fabric, counted in repeats of the print. */
import {norm, type Point} from '../model/geometry/vectors.js';
import {imageCell} from '../model/print/wallpaper.js';
import type {Bolt} from './places.js';

/**
 * Counted from 1: from the left selvedge and from the cut end. The first repeat may be incomplete.
 */
interface CountedRepeats {
  readonly across: number;
  readonly along: number;
}

/** Sides of a cell are parallel to the fabric's edges within this share of their length. */
const straight = 1e-6;
/** Smallest repeat that people can count, unlike the repeat along stripes. [cm] */
const leastCounted = 2;
/** Points this close to the edge of a repeat are on it, as a share of the repeat. */
const slack = 1e-3;

const isAlong = (side: Point, axis: 0 | 1): boolean =>
  Math.abs(side[axis === 0 ? 1 : 0]) < straight * norm(side);

/**
 * Counts the repeats up to a point. Undefined if the repeats are too small to count, or not
 * parallel to the fabric's edges.
 * @param at the lower left corner of a bounding box
 */
export function countedRepeats(
  at: Point,
  {repeat, origin, selvedgeCm}: Bolt,
): CountedRepeats | undefined {
  const cell = imageCell(repeat);
  const [across, along] = isAlong(cell[0], 0) ? cell : [cell[1], cell[0]];
  if (!isAlong(across, 0) || !isAlong(along, 1)) return undefined;
  if (Math.min(norm(across), norm(along)) < leastCounted) return undefined;
  const count = (from: number, to: number, start: number, side: number): number => {
    const [first, here] = [from, to].map((x) => Math.floor((x - start) / side + slack));
    return (here ?? 0) - (first ?? 0) + 1;
  };
  return {
    across: count(selvedgeCm, at[0], origin[0], Math.abs(across[0])),
    along: count(0, at[1], origin[1], Math.abs(along[1])),
  };
}
