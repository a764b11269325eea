/**
 * The mismatch of a print along the seams of a result, for any alignment of its pieces. All
 * displayed figures use the pointwise mismatch. The mismatch under one symmetry per seam shows
 * where the print drifts.
 */
import {determinant, type PlaneMap} from '../model/geometry/plane-map.js';
import {coordinates, distance, type Alignment, type Point} from '../model/geometry/vectors.js';
import type {Pattern, ResultSeam, SeamSide} from '../model/result/result.js';
import {
  joining,
  printDistance,
  printElements,
  reducedBasis,
  type Repeat,
} from '../model/print/wallpaper.js';

/**
 * A seam under an alignment: the mismatch of every edge, and the mean length of its two sides. [cm]
 */
export interface SeamMismatch {
  readonly mismatch: readonly number[];
  readonly lengths: readonly number[];
  /**
   * False if the user excluded the seam, or if it joins a piece to its own mirror image and always
   * matches.
   */
  readonly counts: boolean;
}

export interface PatternMismatch {
  readonly seams: readonly SeamMismatch[];
  /** E_fit: the sum of length times mismatch over the counted seams. [cm2] */
  readonly total: number;
  /** `total` divided by the length of the counted seams. [cm] */
  readonly mean: number;
}

const key = (piece: number, vertex: number | undefined): string => `${piece}:${vertex ?? ''}`;

/**
 * Returns a test for seams that join every vertex to its own mirror image, and therefore match for
 * any alignment.
 */
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

/** For each seam, whether the figures count it. Independent of alignments. */
export function countedSeams(result: Pattern): readonly boolean[] {
  const isTwin = twinTest(result);
  return result.seams.map((seam) => seam.matched && !isTwin(seam));
}

/** Midpoints of a seam's edges in print coordinates, interleaved, and mean edge lengths. */
interface Edges {
  readonly a: Float64Array;
  readonly b: Float64Array;
  readonly lengths: Float64Array;
}

function edgesOf(
  {pieces}: Pattern,
  seam: ResultSeam,
  outline: 'rest' | 'shape',
  alignments: readonly Alignment[],
): Edges {
  const count = Math.max(0, Math.min(seam.a.vertices.length, seam.b.vertices.length) - 1);
  const lengths = new Float64Array(count);
  const middles = ({piece, vertices}: SeamSide): Float64Array => {
    const at = new Float64Array(2 * count);
    const points = pieces[piece]?.[outline] ?? [];
    const {angle, translation} = alignments[piece] ?? {angle: 0, translation: [0, 0]};
    const [c, s] = [Math.cos(angle), Math.sin(angle)];
    for (let k = 0; k < count; k++) {
      const from = points[vertices[k] ?? 0] ?? [0, 0];
      const to = points[vertices[k + 1] ?? 0] ?? [0, 0];
      const dx = (from[0] + to[0]) / 2 - translation[0];
      const dy = (from[1] + to[1]) / 2 - translation[1];
      at[2 * k] = c * dx + s * dy;
      at[2 * k + 1] = c * dy - s * dx;
      lengths[k] = (lengths[k] ?? 0) + distance(from, to) / 2;
    }
    return at;
  };
  return {a: middles(seam.a), b: middles(seam.b), lengths};
}

/** Mean weighted by length. [cm] */
export function meanOf({mismatch, lengths}: Pick<SeamMismatch, 'mismatch' | 'lengths'>): number {
  const length = lengths.reduce((sum, one) => sum + one, 0);
  const total = mismatch.reduce((sum, one, k) => sum + one * (lengths[k] ?? 0), 0);
  return length > 0 ? total / length : 0;
}

/**
 * Returns whether the sides of a seam differ too much in length for a continuous print, with the
 * solver's threshold.
 */
export const isGathered = ({lengthRatio}: Pick<ResultSeam, 'lengthRatio'>): boolean =>
  Math.abs(Math.log(lengthRatio)) > Math.log(1.1);

/**
 * The drift of a seam whose print is not continuous along it: the mismatch at both ends under one
 * symmetry. [cm]
 */
export interface Drift {
  readonly start: number;
  readonly end: number;
  /** The greatest mismatch. */
  readonly most: number;
  /** True beyond the greatest possible pointwise mismatch, where the value is meaningless. */
  readonly isLost: boolean;
}

/**
 * Least excess of the mean mismatch under one symmetry over the pointwise one that counts as drift.
 * [cm]
 */
const leastDrift = 0.3;
/** Length of the ends of a seam, as a share of its whole length. */
const endPart = 0.1;

/** The drift of a seam; undefined if one symmetry for the whole seam matches equally well. */
export function driftOf(
  local: SeamMismatch,
  whole: SeamMismatch,
  {w1, w2}: Repeat,
): Drift | undefined {
  if (meanOf(whole) - meanOf(local) <= leastDrift) return undefined;
  const {mismatch, lengths} = whole;
  const part = endPart * lengths.reduce((sum, one) => sum + one, 0);
  const endOf = (step: 1 | -1): number => {
    const at = (values: readonly number[]): number[] =>
      step > 0 ? [...values] : values.toReversed();
    const [some, long] = [at(mismatch), at(lengths)];
    let way = 0;
    const count = long.findIndex((one) => (way += one) >= part) + 1;
    return meanOf({mismatch: some.slice(0, count), lengths: long.slice(0, count)});
  };
  const [most, [u, v]] = [Math.max(...mismatch), reducedBasis(w1, w2)];
  // no point is farther than half this diagonal from the nearest lattice point
  const isLost = most > Math.hypot(...u, ...v) / 2;
  return {start: endOf(1), end: endOf(-1), most, isLost};
}

/** Sums the counted seams. */
function summed<S extends SeamMismatch>(
  seams: readonly S[],
): PatternMismatch & {readonly seams: readonly S[]} {
  let [total, length] = [0, 0];
  for (const {counts, lengths, mismatch} of seams) {
    if (!counts) continue;
    lengths.forEach((l, k) => {
      length += l;
      total += l * (mismatch[k] ?? 0);
    });
  }
  return {seams, total, mean: length > 0 ? total / length : 0};
}

const pointAt = (points: Float64Array, k: number): Point => [
  points[2 * k] ?? NaN,
  points[2 * k + 1] ?? NaN,
];

/**
 * The mismatch of `rest` or `shape` with one alignment per piece, and the best symmetry of the
 * print for every edge.
 */
export function mismatchOf(
  result: Pattern,
  outline: 'rest' | 'shape',
  alignments: readonly Alignment[],
  counted: readonly boolean[] = countedSeams(result),
): PatternMismatch {
  const apart = printDistance(joining(result.print, result.continuousOnly));
  return summed(
    result.seams.map((seam, number) => {
      const {a, b, lengths} = edgesOf(result, seam, outline, alignments);
      return {
        mismatch: Array.from(lengths, (_, k) => apart(pointAt(a, k), pointAt(b, k))),
        lengths: [...lengths],
        counts: counted[number] ?? false,
      };
    }),
  );
}

/** The mismatch of a result as solved, which the headline and all tables display. */
export const finalMismatch = (result: Pattern, counted?: readonly boolean[]): PatternMismatch =>
  mismatchOf(
    result,
    'shape',
    result.pieces.map(({alignment}) => alignment),
    counted,
  );

/** The worst counted seam: its index and mean. [cm] Undefined if none is counted. */
export function worstOf({
  seams,
}: PatternMismatch): {readonly seam: number; readonly mean: number} | undefined {
  return seams
    .flatMap((one, seam) => (one.counts ? [{seam, mean: meanOf(one)}] : []))
    .reduce<ReturnType<typeof worstOf>>(
      (worst, one) => (worst && worst.mean >= one.mean ? worst : one),
      undefined,
    );
}

/** A seam under a single symmetry of the print, as seen by the eye. */
export interface JoinedSeam extends SeamMismatch {
  /** Effect of the symmetry at the seam: it continues the print, or mirrors it. */
  readonly kind: 'continuous' | 'mirrored';
}

/**
 * Least saving of a mirrored seam over a continuous one, since both are equal along a straight
 * mirror line. [cm2]
 */
const indifference = 1e-6;

/**
 * The mismatch with one symmetry of the print per seam. For each kind of symmetry, the lattice
 * shift nearest to the seam's mean offset and its eight neighbours are tried.
 */
export function joinedMismatchOf(
  result: Pattern,
  outline: 'rest' | 'shape',
  alignments: readonly Alignment[],
  counted: readonly boolean[] = countedSeams(result),
): PatternMismatch & {readonly seams: readonly JoinedSeam[]} {
  const {w1, w2} = result.print;
  const basis = reducedBasis(w1, w2);
  // mirroring symmetries come last, so that they have to be better
  const elements = printElements(joining(result.print, result.continuousOnly)).toSorted(
    (a, b) => determinant(b) - determinant(a),
  );
  return summed(
    result.seams.map((seam, number): JoinedSeam => {
      const edges = edgesOf(result, seam, outline, alignments);
      return {
        ...bestJoin(elements, basis, edges),
        lengths: [...edges.lengths],
        counts: counted[number] ?? false,
      };
    }),
  );
}

function bestJoin(
  elements: readonly PlaneMap[],
  basis: readonly [Point, Point],
  {a, b, lengths}: Edges,
): Pick<JoinedSeam, 'kind' | 'mismatch'> {
  const [u, v] = basis;
  const whole = lengths.reduce((sum, length) => sum + length, 0);
  let least = Infinity;
  let kind: JoinedSeam['kind'] = 'continuous';
  let best = new Float64Array(2 * lengths.length);
  let shift: Point = [0, 0];
  for (const element of elements) {
    const {xx, xy, yx, yy, shift: own} = element;
    const apart = new Float64Array(2 * lengths.length);
    let [mx, my] = [0, 0];
    for (let k = 0; k < lengths.length; k++) {
      const [x, y] = [b[2 * k] ?? 0, b[2 * k + 1] ?? 0];
      const dx = (a[2 * k] ?? 0) - xx * x - xy * y - own[0];
      const dy = (a[2 * k + 1] ?? 0) - yx * x - yy * y - own[1];
      apart[2 * k] = dx;
      apart[2 * k + 1] = dy;
      mx += (dx * (lengths[k] ?? 0)) / whole;
      my += (dy * (lengths[k] ?? 0)) / whole;
    }
    const [s, t] = coordinates(basis, [mx, my]).map(Math.round) as [number, number];
    for (let i = s - 1; i <= s + 1; i++) {
      for (let j = t - 1; j <= t + 1; j++) {
        const sx = i * u[0] + j * v[0];
        const sy = i * u[1] + j * v[1];
        // the sum is at least that of the mean offset
        if (whole * Math.hypot(mx - sx, my - sy) >= least) continue;
        let cost = 0;
        for (let k = 0; k < lengths.length && cost < least; k++) {
          const dx = (apart[2 * k] ?? 0) - sx;
          const dy = (apart[2 * k + 1] ?? 0) - sy;
          cost += (lengths[k] ?? 0) * Math.sqrt(dx * dx + dy * dy);
        }
        if (cost >= least - indifference) continue;
        [least, best, shift] = [cost, apart, [sx, sy]];
        kind = determinant(element) > 0 ? 'continuous' : 'mirrored';
      }
    }
  }
  const mismatch = Array.from(lengths, (_, k) => distance(pointAt(best, k), shift));
  return {kind, mismatch};
}
