/** Where a piece lies on a sheet: shifted, and turned over its head first if it was drawn upside down. Lengths in cm, y up. */
import type {Point} from './geometry.js';

export interface SheetPlace {
  /** Added to the points of a piece, after it was turned. */
  readonly offset: Point;
  /** By half a turn about the origin of its own coordinates. */
  readonly isTurned?: boolean;
}

/** A point of a piece on its sheet. */
export const ontoSheet = ({offset: [dx, dy], isTurned}: SheetPlace, [x, y]: Point): Point =>
  isTurned ? [dx - x, dy - y] : [x + dx, y + dy];

/** A point of the sheet in the coordinates of a piece. */
export const offSheet = ({offset: [dx, dy], isTurned}: SheetPlace, [x, y]: Point): Point =>
  isTurned ? [dx - x, dy - y] : [x - dx, y - dy];

/** A way on the sheet as seen from a piece, or the other way round. */
export const wayOnSheet = ({isTurned}: SheetPlace, [x, y]: Point): Point =>
  isTurned ? [-x, -y] : [x, y];
