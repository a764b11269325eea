/** The least space of a piece over all of its rotations. Lengths in cm. */
import type {MarkerProblem} from '../model/result/marker-search.js';
import {turnedRing, turnsOf, type LayablePiece} from './places.js';

/**
 * The least extent across the fabric and along it, each for the rotation with the smallest value.
 */
export function leastExtents(
  piece: LayablePiece,
  {print, widthCm, selvedgeCm, nap}: MarkerProblem,
): readonly [across: number, along: number] {
  const bolt = {repeat: print, origin: [0, 0], widthCm, selvedgeCm, gapCm: 0, flaws: []} as const;
  const turns = turnsOf(piece, {...bolt, isOneWay: nap === 'one-way'});
  const extents = turns.map(({angle}) => {
    const {low, high} = turnedRing(piece.outline, angle);
    return [high[0] - low[0], high[1] - low[1]] as const;
  });
  return [Math.min(...extents.map(([x]) => x)), Math.min(...extents.map(([, y]) => y))];
}
