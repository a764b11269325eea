import {angleOf, type Point} from '../model/geometry/vectors.js';

/** Arrows in counter-clockwise order, in eighths of a turn. */
const signs = ['→', '↗', '↑', '↖', '←', '↙', '↓', '↘'] as const;

/** Returns the arrow nearest to the direction of a vector, y upwards. */
export function directionSign(vector: Point): string {
  const eighths = Math.round((angleOf(vector) * signs.length) / (2 * Math.PI));
  return signs[(eighths + signs.length) % signs.length] ?? '';
}
