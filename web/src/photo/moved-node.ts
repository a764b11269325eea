import {combined, type Point} from '../model/geometry/vectors.js';
import {latticeOf, rebased} from '../model/print/photo-map.js';
import type {PhotoMap} from '../model/print/photo-reading.js';
import type {PhotoSize} from './lattice-lines.js';

/**
 * Returns the map after a move of one node. A move of `base` shifts all nodes; a move of another
 * node stretches the lattice from `base`. Nodes keep their numbers.
 */
export function movedNode(
  map: PhotoMap,
  size: PhotoSize,
  base: Point,
  node: Point,
  to: Point,
): PhotoMap {
  const [p, q] = latticeOf(map, size, to);
  const [i, j] = [node[0] - base[0], node[1] - base[1]];
  const [du, dv] = [p - node[0], q - node[1]];
  const squared = i * i + j * j;
  // the least change of both vectors that moves the node there
  const [a, b] = squared === 0 ? [0, 0] : [i / squared, j / squared];
  const [w1, w2]: [Point, Point] = [
    [1 + a * du, a * dv],
    [b * du, 1 + b * dv],
  ];
  const start = squared === 0 ? [base[0] + du, base[1] + dv] : base;
  const [x, y] = combined([w1, w2], -base[0], -base[1]);
  return rebased(map, [w1, w2], [start[0] + x, start[1] + y]);
}
