/** What can be clicked: pieces side by side on a sheet, sewn along seams. Lengths in cm, y up. */
import type {Point} from '../model/geometry.js';
import type {ResultPiece, ResultSeam} from '../model/result.js';
import type {SheetPlace} from '../model/sheet-place.js';
import {carried} from '../model/triangles.js';

/** Points are in the piece's own coordinates, not in those of the sheet. */
export interface SheetPiece
  extends SheetPlace, Pick<ResultPiece, 'name' | 'triangles' | 'outline' | 'holes'> {
  /** What people call it. */
  readonly label: string;
  readonly points: readonly Point[];
  /** Per outline edge, from outline[k] to outline[k + 1], the number of the panel's edge in the file. */
  readonly edges?: readonly number[];
  readonly grain?: readonly [Point, Point];
}

type SheetSeam = Pick<ResultSeam, 'a' | 'b'>;

export type Side = keyof SheetSeam;

/** A scene of the viewer is one. */
export interface Sheet {
  readonly pieces: readonly SheetPiece[];
  readonly seams: readonly SheetSeam[];
  /** How the pieces were drafted, one for one. */
  readonly pattern: {readonly pieces: readonly Pick<ResultPiece, 'rest' | 'mirroredFromInput'>[]};
}

/**
 * A point of a piece, in the coordinates of the panel in the file. The sheet may show a deformed
 * piece: the point goes back with the triangle it lies in.
 */
export function inputPoint({pieces, pattern}: Sheet, piece: number, point: Point): Point {
  const {points = [], triangles = []} = pieces[piece] ?? {};
  const {rest = [], mirroredFromInput = false} = pattern.pieces[piece] ?? {};
  const [x, y] = points === rest ? point : carried(triangles, points, rest, point);
  return [mirroredFromInput ? -x : x, y];
}
