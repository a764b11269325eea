/** Features of a pair of edges that ignore the seams of their neighbours. */
import type {MeasuredEdge, MeasuredGarment} from './edges.js';
import {nameFeatures} from './names.js';

/** Gaussian weight of a difference: 1 at zero, 1/e at `width`. */
export const near = (difference: number, width: number): number =>
  Math.exp(-((difference / width) ** 2));

/**
 * Absolute log ratio of two lengths or areas, at most 2: greater values do not separate edges
 * better.
 */
const logRatio = (a: number, b: number): number => Math.min(2, Math.abs(Math.log(a / b)));

/**
 * Root mean square difference of two heading profiles, sewn start to end, at most 2. [rad]
 * @param sign 1 compares edges that bend alike, -1 edges that bend to opposite sides
 */
function unlikeness(a: readonly number[], b: readonly number[], sign: 1 | -1): number {
  let sum = 0;
  const last = b.length - 1;
  for (let k = 0; k <= last; k++) sum += ((a[k] ?? 0) - sign * (b[last - k] ?? 0)) ** 2;
  return Math.min(2, Math.sqrt(sum / b.length));
}

/** A garment's edges, and the features that need the whole garment. */
export interface Surroundings {
  readonly garment: MeasuredGarment;
  /** Mirror image of each edge, or -1. */
  readonly images: Int32Array;
  /** For each edge, the log ratios of its length to all other lengths, ascending. */
  readonly rivals: readonly Float64Array[];
}

export function surroundingsOf(garment: MeasuredGarment, images: Int32Array): Surroundings {
  const {edges} = garment;
  const rivals = edges.map((edge, k) => {
    const others = edges.filter((_, other) => other !== k);
    return Float64Array.from(others, ({length}) => logRatio(edge.length, length)).sort();
  });
  return {garment, images, rivals};
}

/** Returns log(1 + n) for the n ascending numbers below a limit. */
function logBelow(ascending: Float64Array, limit: number): number {
  let low = 0;
  let high = ascending.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if ((ascending[middle] ?? 0) < limit) low = middle + 1;
    else high = middle;
  }
  return Math.log1p(low);
}

/**
 * Returns 1 if the notches meet when the edges are sewn start to end, -1 if they do not, and 0 if
 * neither edge has any.
 */
function notchesAgree(a: readonly number[], b: readonly number[]): number {
  if (a.length + b.length === 0) return 0;
  const last = b.length - 1;
  const meet =
    a.length === b.length && a.every((at, k) => Math.abs(at - 1 + (b[last - k] ?? 0)) < 0.03);
  return meet ? 1 : -1;
}

/** Widths of a log ratio of lengths: exact match, two percent of ease, a seventh of gathers. */
const widths = {exact: 0.003, eased: 0.02, gathered: 0.15};
/** Width of an angle's deviation from a closed joint. [rad] */
const cornerWidth = 0.35;

/** Returns the features of edges `i` and `j`, sewn start to end; symmetric in `i` and `j`. */
export function featuresOf(
  {garment, images, rivals}: Surroundings,
  i: number,
  j: number,
): number[] {
  const {edges, pieces, scale} = garment;
  const [a, b] = [edges[i], edges[j]];
  if (!a || !b) return [];
  const [p, q] = [pieces[a.at.piece], pieces[b.at.piece]];
  const [rivalsA, rivalsB] = [rivals[i], rivals[j]];
  const beside = [edges[a.previous], edges[a.next], edges[b.previous], edges[b.next]] as const;
  const [beforeA, afterA, beforeB, afterB] = beside;
  if (!p || !q || !rivalsA || !rivalsB || !beforeA || !afterA || !beforeB || !afterB) return [];

  const d = logRatio(a.length, b.length);
  const alike = unlikeness(a.profile, b.profile, 1);
  const opposite = unlikeness(a.profile, b.profile, -1);
  const sum1 = a.angle + afterB.angle;
  const sum2 = afterA.angle + b.angle;
  const straight1 = near(sum1 - Math.PI, cornerWidth);
  const straight2 = near(sum2 - Math.PI, cornerWidth);
  const same1 = near(a.angle - afterB.angle, cornerWidth);
  const same2 = near(afterA.angle - b.angle, cornerWidth);
  const d1 = logRatio(beforeA.length, afterB.length);
  const d2 = logRatio(afterA.length, beforeB.length);
  const next1 = near(d1, widths.eased);
  const next2 = near(d2, widths.eased);
  const isSamePiece = p === q;
  const apex = a.after === j ? b.corner : b.after === i ? a.corner : 0;
  const apart = Math.abs(i - j);
  const rankA = logBelow(rivalsA, d - 1e-9);
  const rankB = logBelow(rivalsB, d - 1e-9);
  const equalA = logBelow(rivalsA, 0.01);
  const equalB = logBelow(rivalsB, 0.01);
  const [imageA = -1, imageB = -1] = [images[i], images[j]];
  const logArea = Math.log(Math.min(p.area, q.area) / scale ** 2);
  return [
    near(d, widths.exact),
    near(d, widths.eased),
    near(d, widths.gathered),
    d,
    near(a.length - b.length, 0.004 * scale),
    Math.min(1, Math.abs(a.length - b.length) / scale),
    Math.log((a.length + b.length) / scale),
    near(alike, 0.05),
    alike,
    near(opposite, 0.05),
    opposite,
    Math.abs(a.turning + b.turning),
    Math.abs(a.turning - b.turning),
    (sum1 + sum2) / Math.PI,
    Math.abs(sum1 - sum2) / Math.PI,
    straight1 + straight2,
    straight1 * straight2,
    same1 + same2,
    same1 * same2,
    next1 + next2,
    next1 * next2,
    Math.min(d1, d2),
    Number(isSamePiece),
    Number(apex > 0),
    apex / Math.PI,
    Number(isSamePiece && (apart === 2 || apart === p.count - 2)),
    Number(imageA === j),
    Number(imageA === i) + Number(imageB === j),
    Number(!isSamePiece && imageA >= 0 && edges[imageA]?.at.piece === b.at.piece),
    Number(imageA < 0) + Number(imageB < 0),
    Math.min(rankA, rankB),
    Math.max(rankA, rankB),
    Math.min(equalA, equalB),
    Math.max(equalA, equalB),
    notchesAgree(a.notches, b.notches),
    p.words.side * q.words.side,
    p.words.face * q.words.face,
    Number(p.words.isSleeve && q.words.isSleeve),
    Number(p.words.isSleeve !== q.words.isSleeve),
    Number(p.material !== q.material),
    ...nameFeatures(garment, a, b),
    ...orientations(a, b),
    logRatio(p.area, q.area),
    logArea,
    Math.min(a.share, b.share),
    Math.max(a.share, b.share),
    Math.log(Math.min(p.count, q.count)),
    Math.log(Math.max(p.count, q.count)),
  ];
}

/**
 * Direction and place of two edges relative to the grain: side seams run along it, hems are at the
 * foot.
 */
const orientations = (a: MeasuredEdge, b: MeasuredEdge): readonly number[] => [
  a.chord[0] * b.chord[0],
  a.chord[1] * b.chord[1],
  Math.abs(a.chord[1]) + Math.abs(b.chord[1]),
  Math.abs(a.place[1] - b.place[1]),
  a.place[1] + b.place[1],
  Math.abs(Math.abs(a.place[0]) - Math.abs(b.place[0])),
  Math.abs(a.place[0]) + Math.abs(b.place[0]),
];
