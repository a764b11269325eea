/** How well a print meets along the seams of a result, under any alignment of its pieces. */
import type {Alignment, Point} from '../model/geometry.js';
import type {Pattern, ResultSeam} from '../model/result.js';
import {printDistance} from '../model/wallpaper.js';

/** A seam under an alignment: the mismatch of every edge and the mean length of its two sides. [cm] */
export interface SeamFit {
  readonly mismatch: readonly number[];
  readonly lengths: readonly number[];
  /** False: the user switched it off, or it joins a piece to its own mirror twin and always matches. */
  readonly counts: boolean;
}

export interface Fit {
  readonly seams: readonly SeamFit[];
  /** E_fit: the sum of length times mismatch over the seams that count. [cm2] */
  readonly total: number;
  /** `total` over the length of those seams. [cm] */
  readonly mean: number;
}

/** A point of a piece as a point of the print: R(angle)^T (p - translation). */
export function onPrint({angle, translation}: Alignment, [x, y]: Point): Point {
  const dx = x - translation[0];
  const dy = y - translation[1];
  const c = Math.cos(angle);
  const s = Math.sin(angle);
  return [c * dx + s * dy, c * dy - s * dx];
}

const key = (piece: number, vertex: number | undefined): string => `${piece}:${vertex ?? ''}`;

/** Whether a seam joins every vertex to its own mirror image, so that it matches however the print lies. */
function twinTest(result: Pattern): (seam: ResultSeam) => boolean {
  const images = new Map<string, string>();
  for (const symmetry of result.symmetries) {
    const [first, second] =
      symmetry.kind === 'piece' ? [symmetry.piece, symmetry.piece] : symmetry.pieces;
    for (const [i, j] of symmetry.pairs) {
      images.set(key(first, i), key(second, j));
      images.set(key(second, j), key(first, i));
    }
  }
  return ({a, b}) =>
    a.vertices.every((v, k) => images.get(key(a.piece, v)) === key(b.piece, b.vertices[k]));
}

const middle = (a: Point, b: Point): Point => [(a[0] + b[0]) / 2, (a[1] + b[1]) / 2];
const distance = (a: Point, b: Point): number => Math.hypot(a[0] - b[0], a[1] - b[1]);

/** The fit of `rest` or `shape`, with one alignment per piece. */
export function fitOf(
  result: Pattern,
  outline: 'rest' | 'shape',
  alignments: readonly Alignment[],
): Fit {
  const apart = printDistance(result.print);
  const isTwin = twinTest(result);
  let total = 0;
  let length = 0;
  const edges = (side: ResultSeam['a']): {at: Point; length: number}[] => {
    const points = result.pieces[side.piece]?.[outline] ?? [];
    const alignment = alignments[side.piece] ?? {angle: 0, translation: [0, 0]};
    const line = side.vertices.flatMap((v) => points.slice(v, v + 1));
    return line.slice(1).map((to, k) => {
      const from = line[k] ?? to;
      return {at: onPrint(alignment, middle(from, to)), length: distance(from, to)};
    });
  };
  const seams = result.seams.map((seam): SeamFit => {
    const a = edges(seam.a);
    const b = edges(seam.b);
    const counts = seam.matched && !isTwin(seam);
    const mismatch: number[] = [];
    const lengths: number[] = [];
    a.forEach((edge, k) => {
      const partner = b[k] ?? edge;
      mismatch.push(apart(edge.at, partner.at));
      lengths.push((edge.length + partner.length) / 2);
    });
    if (counts) {
      lengths.forEach((l, k) => {
        length += l;
        total += l * (mismatch[k] ?? 0);
      });
    }
    return {mismatch, lengths, counts};
  });
  return {seams, total, mean: length > 0 ? total / length : 0};
}
