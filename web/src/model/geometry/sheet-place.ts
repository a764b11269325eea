/**
 * Place of a piece on a sheet: turned by half a turn if it was drawn upside down, then shifted.
 * Lengths in cm, y up.
 */
import type {Point} from './vectors.js';

export interface SheetPlace {
  /** Shift of the points of a piece, after the turn. */
  readonly offset: Point;
  /** True if the piece is turned by half a turn about the origin of its own coordinates. */
  readonly isTurned?: boolean;
}

/** Maps a point of a piece to its sheet. */
export const ontoSheet = ({offset: [dx, dy], isTurned}: SheetPlace, [x, y]: Point): Point =>
  isTurned ? [dx - x, dy - y] : [x + dx, y + dy];

/** Maps a point of the sheet to the coordinates of a piece. */
export const offSheet = ({offset: [dx, dy], isTurned}: SheetPlace, [x, y]: Point): Point =>
  isTurned ? [dx - x, dy - y] : [x - dx, y - dy];

/** Maps a vector between sheet and piece, in either direction. */
export const wayOnSheet = ({isTurned}: SheetPlace, [x, y]: Point): Point =>
  isTurned ? [-x, -y] : [x, y];
