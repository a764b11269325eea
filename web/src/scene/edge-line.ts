/** Edges of a panel along the outline of its piece as it is shown. */
import type {Point} from '../model/geometry.js';
import {pick} from './marks.js';
import type {ScenePiece} from './scene.js';

/** The vertices along an edge of the file, from its start to its end; none where nothing says which they are. */
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

/** The same as points of the piece. [cm] */
export const edgePoints = (piece: ScenePiece, edge: number): readonly Point[] =>
  pick(piece.points, edgeVertices(piece, edge));
