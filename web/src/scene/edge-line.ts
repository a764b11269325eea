/** Edges of a panel along the displayed outline of its piece. */
import type {Point} from '../model/geometry/vectors.js';
import {pick} from './marks.js';
import type {ScenePiece} from './scene.js';

/** The vertices along an edge of the file, from start to end; empty if they are unknown. */
export function edgeVertices(
  {outline, edges = []}: Pick<ScenePiece, 'outline' | 'edges'>,
  edge: number,
): readonly number[] {
  const count = outline.length;
  const isOf = (k: number): boolean => edges[(k + count) % count] === edge;
  const first = outline.findIndex((_, k) => isOf(k) && !isOf(k - 1));
  const start = first < 0 && isOf(0) ? 0 : first; // all of the outline
  if (start < 0) return [];
  let steps = 0;
  while (steps < count && isOf(start + steps)) steps++;
  return Array.from({length: steps + 1}, (_, k) => outline[(start + k) % count] ?? 0);
}

/** The points along an edge, in piece coordinates. [cm] */
export const edgePoints = (piece: ScenePiece, edge: number): readonly Point[] =>
  pick(piece.points, edgeVertices(piece, edge));
