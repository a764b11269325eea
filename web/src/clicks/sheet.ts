/** What can be clicked: pieces side by side on a sheet, sewn along seams. Lengths in cm, y up. */
import type {Point} from '../model/geometry.js';
import type {ResultPiece, ResultSeam} from '../model/result.js';
import type {SheetPlace} from '../model/sheet-place.js';

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

export type SheetSeam = Pick<ResultSeam, 'a' | 'b'>;

export type Side = keyof SheetSeam;

/** A scene of the viewer is one. */
export interface Sheet {
  readonly pieces: readonly SheetPiece[];
  readonly seams: readonly SheetSeam[];
  /** How the pieces were drafted, one for one. */
  readonly pattern: {readonly pieces: readonly Pick<ResultPiece, 'rest' | 'mirroredFromInput'>[]};
}

/** Weights of a triangle's corners that make up a point; the least is negative outside of it. */
function weightsIn([a, b, c]: readonly [Point, Point, Point], [x, y]: Point): readonly number[] {
  const double = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
  const opposite = (p: Point, q: Point): number =>
    ((p[0] - x) * (q[1] - y) - (q[0] - x) * (p[1] - y)) / double;
  return [opposite(b, c), opposite(c, a), opposite(a, b)];
}

/**
 * A point of a piece, in the coordinates of the panel in the file. The sheet may show a deformed
 * piece: the point goes back with the triangle it lies in.
 */
export function inputPoint({pieces, pattern}: Sheet, piece: number, point: Point): Point {
  const {points = [], triangles = []} = pieces[piece] ?? {};
  const {rest = [], mirroredFromInput = false} = pattern.pieces[piece] ?? {};
  const origin: Point = [0, 0];
  let inmost = -Infinity;
  let drafted = point;
  for (const [i, j, k] of points === rest ? [] : triangles) {
    const [a = origin, b = origin, c = origin] = [points[i], points[j], points[k]];
    const weights = weightsIn([a, b, c], point);
    const least = Math.min(...weights);
    if (!(least > inmost)) continue;
    inmost = least;
    const corners = [rest[i], rest[j], rest[k]];
    const mean = (axis: 0 | 1): number =>
      weights.reduce((sum, weight, n) => sum + weight * (corners[n] ?? origin)[axis], 0);
    drafted = [mean(0), mean(1)];
  }
  return [mirroredFromInput ? -drafted[0] : drafted[0], drafted[1]];
}
