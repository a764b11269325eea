/** Clickable sheet: pieces side by side, sewn along seams. Lengths in cm, y up. */
import type {Point} from '../model/geometry/vectors.js';
import type {ResultPiece, ResultSeam} from '../model/result/result.js';
import type {SheetPlace} from '../model/geometry/sheet-place.js';
import {carried} from '../model/geometry/triangles.js';

/** Points are in the piece's own coordinates, not in those of the sheet. */
export interface SheetPiece
  extends SheetPlace, Pick<ResultPiece, 'name' | 'triangles' | 'outline' | 'holes'> {
  /** Name shown to the user. */
  readonly label: string;
  readonly points: readonly Point[];
  /**
   * Number of the panel's edge in the file for each outline edge, from outline[k] to outline[k +
   * 1].
   */
  readonly edges?: readonly number[];
  readonly grain?: readonly [Point, Point];
}

type SheetSeam = Pick<ResultSeam, 'a' | 'b'>;

export type Side = keyof SheetSeam;

/** Scenes of the viewer implement it. */
export interface Sheet {
  readonly pieces: readonly SheetPiece[];
  readonly seams: readonly SheetSeam[];
  /** The drafted pieces, in the same order. */
  readonly pattern: {readonly pieces: readonly Pick<ResultPiece, 'rest' | 'mirroredFromInput'>[]};
}

/**
 * Converts a point of a piece to the coordinates of its panel in the file. The sheet may show a
 * deformed piece, so the point moves back with its triangle.
 */
export function inputPoint({pieces, pattern}: Sheet, piece: number, point: Point): Point {
  const {points = [], triangles = []} = pieces[piece] ?? {};
  const {rest = [], mirroredFromInput = false} = pattern.pieces[piece] ?? {};
  const [x, y] = points === rest ? point : carried(triangles, points, rest, point);
  return [mirroredFromInput ? -x : x, y];
}

/** Converts a point of a piece to its drafted state, face up. [cm] */
export function draftedPoint(sheet: Sheet, piece: number, point: Point): Point {
  const [x, y] = inputPoint(sheet, piece, point);
  return [sheet.pattern.pieces[piece]?.mirroredFromInput ? -x : x, y];
}
