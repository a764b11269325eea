/** Lines, corners and midpoints of a sheet, computed once for many clicks. Lengths in cm. */
import {minus, radians, turnBetween, type Point} from '../model/geometry/vectors.js';
import {pathRound, pathThrough, placeAt, type Path} from './path.js';
import type {Sheet, SheetPiece, Side} from './sheet.js';

/** A side of a seam, or an edge of the panel without a seam. */
type LineName =
  | {readonly kind: 'seam'; readonly seam: number; readonly side: Side}
  | {readonly kind: 'edge'; readonly edge: number};

export interface Line {
  readonly name: LineName;
  /** Seam sides run in sewing order, edges counter-clockwise. */
  readonly path: Path;
  /** Number of the outline's edge for each segment of the path. */
  readonly along: readonly (number | undefined)[];
  /** First edge of the outline on this line, counter-clockwise. */
  readonly start: number;
}

/** All points are in the piece's own coordinates. */
interface PieceIndex {
  readonly outline: Path;
  readonly holes: readonly Path[];
  /** Lines, sorted in the order of the outline. */
  readonly lines: readonly Line[];
  /** Ends of the panel's edges, and sharp turns of the drafted outline. */
  readonly corners: readonly Point[];
  /**
   * Midpoints of the panel's edges, or of the stretches between corners if edge numbers are
   * missing.
   */
  readonly midpoints: readonly Point[];
}

export interface PickIndex {
  readonly sheet: Sheet;
  readonly pieces: readonly PieceIndex[];
}

/** Least turn of an outline at a corner. */
const sharpTurn = radians(30);

interface Run<T> {
  readonly key: T;
  readonly start: number;
  readonly count: number;
}

/** Returns stretches of equal keys around a loop; a stretch may continue past the loop's end. */
function runsRound<T>(keys: readonly T[]): readonly Run<T>[] {
  const n = keys.length;
  const starts = keys.flatMap((key, k) => (key === keys[(k + n - 1) % n] ? [] : [k]));
  const bounds = starts.length > 0 ? starts : keys.slice(0, 1).map(() => 0);
  return bounds.flatMap((start, k) =>
    keys.slice(start, start + 1).map((key) => ({
      key,
      start,
      count: (bounds[k + 1] ?? (bounds[0] ?? 0) + n) - start,
    })),
  );
}

const pointsAt = (points: readonly Point[], vertices: readonly number[]): readonly Point[] =>
  vertices.map((v) => points[v] ?? [NaN, NaN]);

const verticesOf = ({outline}: SheetPiece, {start, count}: Run<unknown>): readonly number[] =>
  Array.from({length: count + 1}, (_, k) => outline[(start + k) % outline.length] ?? 0);

/** Returns the numbers of the outline's points at which it turns sharply. */
function sharpCorners({segments}: Path): readonly number[] {
  return segments.flatMap(({from, to}, k) => {
    const before = segments.at(k - 1);
    if (!before) return [];
    const turn = turnBetween(minus(before.to, before.from), minus(to, from));
    return Math.abs(turn) >= sharpTurn ? [k] : [];
  });
}

/** Numbers the stretches between corners, which replace missing edge numbers. */
function stretches(outline: Path, corners: readonly number[]): readonly number[] {
  return outline.segments.map(
    (_, k) => corners.filter((corner) => corner <= k).length % Math.max(corners.length, 1),
  );
}

function seamLines(sheet: Sheet, number: number, piece: SheetPiece): readonly Line[] {
  const {outline} = piece;
  const position = new Map(outline.map((v, k) => [v, k]));
  return sheet.seams.flatMap((ends, seam) =>
    (['a', 'b'] as const).flatMap((side): Line[] => {
      const {piece: on, vertices} = ends[side];
      const [first = -1, second] = vertices;
      if (on !== number) return [];
      const isForward = outline[((position.get(first) ?? -1) + 1) % outline.length] === second;
      const along = (isForward ? vertices.slice(0, -1) : vertices.slice(1)).map((v) =>
        position.get(v),
      );
      const path = pathThrough(pointsAt(piece.points, vertices));
      const start = along.at(isForward ? 0 : -1) ?? outline.length;
      return [{name: {kind: 'seam', seam, side}, path, along, start}];
    }),
  );
}

/** Returns the unsewn edges as lines; none if edge numbers are missing. */
function edgeLines(piece: SheetPiece, sewn: ReadonlySet<number | undefined>): readonly Line[] {
  const keys = piece.outline.map((_, k) => (sewn.has(k) ? undefined : piece.edges?.[k]));
  return runsRound(keys).flatMap((run): Line[] => {
    if (run.key === undefined) return [];
    const path = pathThrough(pointsAt(piece.points, verticesOf(piece, run)));
    const along = path.segments.map((_, k) => (run.start + k) % piece.outline.length);
    return [{name: {kind: 'edge', edge: run.key}, path, along, start: run.start}];
  });
}

function pieceIndex(sheet: Sheet, number: number, piece: SheetPiece): PieceIndex {
  const outline = pathRound(pointsAt(piece.points, piece.outline));
  const drafted = sheet.pattern.pieces[number]?.rest ?? piece.points;
  const sharp = sharpCorners(pathRound(pointsAt(drafted, piece.outline)));
  const runs = runsRound(piece.edges ?? stretches(outline, sharp));
  const parts = runs.length > 1 ? runs : []; // a single one has no ends
  const corners = new Set([...sharp, ...parts.map(({start}) => start)]);
  const seams = seamLines(sheet, number, piece);
  const edges = edgeLines(piece, new Set(seams.flatMap(({along}) => along)));
  return {
    outline,
    holes: piece.holes.map((hole) => pathRound(pointsAt(piece.points, hole))),
    lines: [...seams, ...edges].sort((one, other) => one.start - other.start),
    corners: outline.segments.flatMap(({from}, k) => (corners.has(k) ? [from] : [])),
    midpoints: parts.flatMap((part) => {
      const path = pathThrough(pointsAt(piece.points, verticesOf(piece, part)));
      const middle = placeAt(path, path.length / 2);
      return middle ? [middle.point] : [];
    }),
  };
}

export const pickIndex = (sheet: Sheet): PickIndex => ({
  sheet,
  pieces: sheet.pieces.map((piece, number) => pieceIndex(sheet, number, piece)),
});

/** A sheet of one size, drafted or as solved. */
type SizedSheet = Sheet & {readonly outline: unknown; readonly size: unknown};

/** Index for clicks; it stays valid while only the alignments change. */
export class SheetIndex {
  #for: Pick<SizedSheet, 'pattern' | 'outline' | 'size'> | undefined;
  #index: PickIndex | undefined;

  of(sheet: SizedSheet): PickIndex {
    const {pattern, outline, size} = sheet;
    const known = this.#for;
    if (
      this.#index &&
      known?.pattern === pattern &&
      known.outline === outline &&
      known.size === size
    )
      return this.#index;
    this.#for = {pattern, outline, size};
    return (this.#index = pickIndex(sheet));
  }
}
