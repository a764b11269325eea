/** In which repeat of the print something on the cloth begins: how people find it on a bolt. */
import {norm, type Point} from '../model/geometry.js';
import {imageCell} from '../model/wallpaper.js';
import type {Bolt} from './places.js';

/** Counted from 1: from the left selvedge, and from where the cloth is cut. The first may be cut off. */
interface CountedRepeats {
  readonly across: number;
  readonly along: number;
}

/** Sides of a cell lie along the cloth where they miss it by less than this share of their length. */
const straight = 1e-6;
/** Nobody counts repeats that are smaller, as those along stripes. [cm] */
const leastCounted = 2;
/** Of a repeat: what misses its edge by less lies on it. */
const slack = 1e-3;

const isAlong = (side: Point, axis: 0 | 1): boolean =>
  Math.abs(side[axis === 0 ? 1 : 0]) < straight * norm(side);

/** Undefined where the repeats do not lie along the edges of the cloth, so that nobody can count them, or are too small. @param at the lower left corner of the box around it */
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
