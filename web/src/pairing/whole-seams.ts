/** Joins likely pairs of edges to whole seams, such as a side seam of three edges on each side. */
import type {EdgeOfPiece, GarmentDocument} from '../model/garment/garment-document.js';
import type {SeamPlace} from '../model/result/result.js';
import {Boundary, type Step} from './boundary.js';
import {likelyPairs, type LikelyPairs, type Pair} from './likely-pairs.js';
import {placeOf, stepOf} from './places.js';
import {edgeAt, meetsAtStarts, type PairingHooks} from './rank.js';
import {scoresOf, type Scores} from './scores.js';

/** Edges that are sewn to each other, in their order along a seam. */
export type Parts = readonly (readonly [EdgeOfPiece, EdgeOfPiece])[];

/** A seam from corner to corner. */
export interface WholeSeam {
  readonly parts: Parts;
  /** The seam on the other side of the body; empty without one. */
  readonly images: Parts;
  readonly place: SeamPlace;
  /** Likelihood, from 0 to 1. */
  readonly p: number;
  /** Start meets start. */
  readonly sameDirection: boolean;
}

/** Greatest deviation of a boundary that goes straight on. [rad] */
const straight = 0.6;
/** Least likelihood of a further part of a seam. */
const leastPart = 0.2;

const isStraight = ({angle}: Step): boolean => Math.abs(angle - Math.PI) < straight;

/** Adds the parts beyond the end of a seam's first side, as far as both boundaries go straight on. */
function extended({of}: LikelyPairs, boundary: Boundary, pairs: readonly Pair[]): readonly Pair[] {
  const all = [...pairs];
  const used = new Set(pairs.flat());
  for (;;) {
    const [a = -1, b = -1] = all.at(-1) ?? [];
    const [next, other] = [boundary.after(a), boundary.before(b)];
    if (!next || !other || !isStraight(next) || !isStraight(other)) return all;
    const pair: Pair = [next.edge, other.edge];
    if (next.edge === other.edge || pair.some((edge) => used.has(edge))) return all;
    if (of(pair) < leastPart) return all;
    all.push(pair);
    pair.forEach((edge) => used.add(edge));
  }
}

const turned = (pairs: readonly Pair[]): readonly Pair[] =>
  pairs.map(([a, b]): Pair => [b, a]).reverse();

/** Returns whether one side goes straight on where the other ends, as at a missing seam. */
function isUneven(boundary: Boundary, [a, b]: Pair): boolean {
  const goesOn = [boundary.after(a), boundary.before(b)].map((step) => step && isStraight(step));
  return goesOn[0] !== goesOn[1];
}

const unevenEnds = (boundary: Boundary, pairs: readonly Pair[]): number =>
  [pairs, turned(pairs)].filter((side) => {
    const last = side.at(-1);
    return last && isUneven(boundary, last);
  }).length;

/** Subtracted from the log odds for each uneven end. */
const doubt = 0.7;

const logit = (p: number): number => Math.log((p + 1e-4) / (1 - p + 1e-4));

/** Returns the mean log odds of a seam's parts, weighted by their length. */
function meanOdds({garment: {edges}}: Scores, {of}: LikelyPairs, pairs: readonly Pair[]): number {
  let [sum, total] = [0, 0];
  for (const pair of pairs) {
    const length = (edges[pair[0]]?.length ?? 0) + (edges[pair[1]]?.length ?? 0);
    sum += length * logit(of(pair));
    total += length;
  }
  return sum / total;
}

/** Returns the parts of the seam on the other side of the body, if that is likely, too. */
function imagesOf(
  {images, isFree}: Scores,
  {of}: LikelyPairs,
  pairs: readonly Pair[],
): readonly Pair[] {
  const own = new Set(pairs.flat());
  const found = pairs.map(([a, b]): Pair => [images[a] ?? -1, images[b] ?? -1]);
  const isSeam = found.every(
    ([a, b]) => a !== b && isFree[a] === 1 && isFree[b] === 1 && of([a, b]) >= leastPart,
  );
  return isSeam && found.every((pair) => pair.every((edge) => !own.has(edge))) ? found : [];
}

/** Returns the longest part of a seam, which decides on its place. */
const longest = ({garment: {edges}}: Scores, pairs: readonly Pair[]): Pair =>
  pairs.reduce((best, pair) =>
    (edges[pair[0]]?.length ?? 0) > (edges[best[0]]?.length ?? 0) ? pair : best,
  );

/** Likelihood from which the order of sewing decides. */
const likely = 0.8;

/** Returns the step at which a seam is asked about: likely seams in the order of sewing. */
const rankOf = ({place, p}: WholeSeam): number => (p >= likely ? stepOf(place) : Infinity);

const byRank = (one: WholeSeam, other: WholeSeam): number => {
  const [first, second] = [rankOf(one), rankOf(other)];
  return first === second ? other.p - one.p : first - second;
};

function seamsIn(
  scores: Scores,
  garment: GarmentDocument,
  least: number,
  joins: boolean,
): readonly WholeSeam[] {
  const boundary = new Boundary(scores.garment, garment);
  const pairs = likelyPairs(scores, garment, joins);
  const seeds = [...pairs.best.entries()]
    .map(([a, b]) => ({a, b, p: b < 0 ? 0 : pairs.of([a, b])}))
    .filter(({a, b, p}) => p >= least && (a < b || pairs.best[b] !== a))
    .sort((one, other) => other.p - one.p);
  const used = new Set<number>();
  const isLeft = (pair: Pair): boolean => pair.every((edge) => !used.has(edge));
  const partsOf = (list: readonly Pair[]): Parts =>
    list.map(([a, b]) => [edgeAt(scores, a), edgeAt(scores, b)] as const);
  return seeds
    .flatMap(({a, b}): WholeSeam[] => {
      if (!isLeft([a, b])) return [];
      const onwards = extended(pairs, boundary, [[a, b]]);
      const own = turned(extended(pairs, boundary, turned(onwards))).filter(isLeft);
      const images = imagesOf(scores, pairs, own).filter(isLeft);
      [...own, ...images].flat().forEach((edge) => used.add(edge));
      const odds = meanOdds(scores, pairs, own) - doubt * unevenEnds(boundary, own);
      return [
        {
          parts: partsOf(own),
          images: partsOf(images),
          place: placeOf(scores.garment, ...longest(scores, own)),
          p: 1 / (1 + Math.exp(-odds)),
          sameDirection: meetsAtStarts(garment, edgeAt(scores, a), edgeAt(scores, b)),
        },
      ];
    })
    .filter(({p}) => p >= least)
    .sort(byRank);
}

/**
 * Returns likely whole seams that share no edge: in the order of sewing if they are almost certain,
 * then the likeliest first. If there are none, seams that join separate parts count as likelier.
 * @param least least likelihood, from 0 to 1
 */
export function wholeSeams(
  garment: GarmentDocument,
  least: number,
  {refused = []}: PairingHooks = {},
): readonly WholeSeam[] {
  const scores = scoresOf(garment, refused);
  const found = seamsIn(scores, garment, least, false);
  return found.length > 0 ? found : seamsIn(scores, garment, least, true);
}
