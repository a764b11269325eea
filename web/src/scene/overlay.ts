/**
 * Marks over the sheet while the user points, selects or marks. Points are in the coordinates of a
 * piece. [cm]
 */
import type {Point} from '../model/geometry/vectors.js';
import type {SceneSymmetry} from './scene-marks.js';
import {pick} from './marks.js';
import type {ScenePiece} from './scene.js';

// Edges of a panel along the displayed outline of its piece.

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

export interface OnPiece {
  readonly piece: number;
  readonly point: Point;
}

export interface Overlay {
  /** Both sides of a seam with a thread between them; the side under the pointer is emphasized. */
  readonly highlight?: {readonly seam: number; readonly side?: 'a' | 'b'};
  readonly hoverPiece?: number;
  readonly selectPiece?: number;
  /** Shows the letters of all pairs, not only of that under the pointer. */
  readonly allPairs?: boolean;
  /** Found symmetries that are not imposed yet. */
  readonly ghosts?: readonly SceneSymmetry[];
  /** A mirror axis that is being drawn. */
  readonly candidate?: {readonly piece: number; readonly axis: readonly [Point, Point]};
  readonly points?: readonly (OnPiece & {readonly label?: string})[];
  readonly lines?: readonly {
    readonly piece: number;
    readonly line: readonly Point[];
    /** Default `chosen`. */
    readonly look?: LineLook;
  }[];
  /** Threads between points that coincide in the garment. */
  readonly threads?: readonly {
    readonly from: OnPiece;
    readonly to: OnPiece;
    readonly isFaint?: boolean;
  }[];
  /** Numbers beside lines, on the side of the direction `inwards`. */
  readonly badges?: readonly (OnPiece & {readonly inwards: Point; readonly text: string})[];
  readonly cursors?: readonly OnPiece[];
  /** Lines that a click may jump to. */
  readonly rails?: readonly {readonly piece: number; readonly line: readonly [Point, Point]}[];
  /** Decisions about a piece, as a sign on it. */
  readonly signs?: readonly (OnPiece & {readonly sign: Sign})[];
  readonly message?: OnPiece & {readonly text: string; readonly tone: 'error' | 'info'};
}

export type Sign = 'pin' | 'lock';

/** `lit`: may be chosen; `faint`: suggested; `open`: stays as it is; `fold`: a fold of the garment. */
export type LineLook = 'chosen' | 'lit' | 'faint' | 'open' | 'fold';
