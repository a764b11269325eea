/** Joins likely pairs of edges to whole seams, such as a side seam of three edges on each side. */
import type {EdgeOfPiece, GarmentDocument} from '../model/garment/garment-document.js';
import {Boundary, type Step} from './boundary.js';
import {edgeAt, partnersIn, meetsAtStarts, type PairingHooks} from './rank.js';
import {scoresOf, type Scores} from './scores.js';

/** Two edges, by number. */
type Pair = readonly [number, number];

/** A seam from corner to corner. */
export interface WholeSeam {
  /** Its parts along the first side: edges that are sewn to each other. */
  readonly pairs: readonly (readonly [EdgeOfPiece, EdgeOfPiece])[];
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

const likelihoodOf = ({likelihoods: {size, values}}: Scores, [a, b]: Pair): number =>
  values[a * size + b] ?? 0;

/** Adds the parts beyond the end of a seam's first side, as far as both boundaries go straight on. */
function extended(scores: Scores, boundary: Boundary, pairs: readonly Pair[]): readonly Pair[] {
  const all = [...pairs];
  const used = new Set(pairs.flat());
  for (;;) {
    const [a = -1, b = -1] = all.at(-1) ?? [];
    const [next, other] = [boundary.after(a), boundary.before(b)];
    if (!next || !other || !isStraight(next) || !isStraight(other)) return all;
    const pair: Pair = [next.edge, other.edge];
    if (next.edge === other.edge || used.has(next.edge) || used.has(other.edge)) return all;
    if (likelihoodOf(scores, pair) < leastPart) return all;
    all.push(pair);
    pair.forEach((edge) => used.add(edge));
  }
}

const turned = (pairs: readonly Pair[]): readonly Pair[] =>
  pairs.map(([a, b]): Pair => [b, a]).reverse();

const logit = (p: number): number => Math.log((p + 1e-4) / (1 - p + 1e-4));

/** Returns the likelihood of a seam: its parts weighted by their length. */
function wholeLikelihood(scores: Scores, pairs: readonly Pair[]): number {
  const {edges} = scores.garment;
  let [sum, total] = [0, 0];
  for (const pair of pairs) {
    const length = (edges[pair[0]]?.length ?? 0) + (edges[pair[1]]?.length ?? 0);
    sum += length * logit(likelihoodOf(scores, pair));
    total += length;
  }
  return 1 / (1 + Math.exp(-sum / total));
}

/**
 * Returns whole seams that share no edge, the likeliest first.
 * @param least least likelihood of their likeliest part, from 0 to 1
 */
export function wholeSeams(
  garment: GarmentDocument,
  least: number,
  {refused = []}: PairingHooks = {},
): readonly WholeSeam[] {
  const scores = scoresOf(garment, refused);
  const boundary = new Boundary(scores.garment, garment);
  const best = scores.garment.edges.map((_, edge) => partnersIn(scores, edge)[0]);
  const seeds = best
    .filter((one) => one !== undefined)
    .filter(({a, b, p}) => a < b && p >= least && best[b]?.b === a)
    .sort((one, other) => other.p - one.p);
  const used = new Set<number>();
  const found: WholeSeam[] = [];
  for (const {a, b} of seeds) {
    if (used.has(a) || used.has(b)) continue;
    const onwards = extended(scores, boundary, [[a, b]]);
    const pairs = turned(extended(scores, boundary, turned(onwards)));
    const own = pairs.filter((pair) => pair.every((edge) => !used.has(edge)));
    own.flat().forEach((edge) => used.add(edge));
    const ends = own.map(([one, other]) => [edgeAt(scores, one), edgeAt(scores, other)] as const);
    const [from, to] = [edgeAt(scores, a), edgeAt(scores, b)];
    found.push({
      pairs: ends,
      p: wholeLikelihood(scores, own),
      sameDirection: meetsAtStarts(garment, from, to),
    });
  }
  return found.sort((one, other) => other.p - one.p);
}
