/**
 * Marks over the sheet while the user points, selects or marks. Points are in the coordinates of a
 * piece. [cm]
 */
import type {Point} from '../model/geometry/vectors.js';
import type {SceneSymmetry} from './scene-marks.js';

export interface OnPiece {
  readonly piece: number;
  readonly point: Point;
}

export interface Overlay {
  /** Both sides of a seam with a thread between them; the side under the pointer is emphasized. */
  readonly highlight?: {readonly seam: number; readonly side?: 'a' | 'b'};
  readonly hoverPiece?: number;
  readonly selectPiece?: number;
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

/** `lit`: may be chosen; `faint`: suggested; `open`: stays as it is. */
export type LineLook = 'chosen' | 'lit' | 'faint' | 'open';
