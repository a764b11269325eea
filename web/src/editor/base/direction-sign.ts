import {angleOf, type Point} from '../../model/geometry.js';

/** Counter-clockwise, by eighths of a turn. */
const signs = ['→', '↗', '↑', '↖', '←', '↙', '↓', '↘'] as const;

/** The arrow that points most nearly as a vector does, y upwards. */
export function directionSign(vector: Point): string {
  const eighths = Math.round((angleOf(vector) * signs.length) / (2 * Math.PI));
  return signs[(eighths + signs.length) % signs.length] ?? '';
}
