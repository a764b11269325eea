/** Joins likely pairs of edges to whole seams, such as a side seam of three edges on each side. */
import type {EdgeOfPiece, GarmentDocument} from '../model/garment/garment-document.js';
import {Boundary, type Step} from './boundary.js';
import type {SeamPlace} from '../model/result/result.js';
import {copiesOf} from './congruent.js';
import {placeOf, stepOf} from './places.js';
import {edgeAt, meetsAtStarts, type PairingHooks} from './rank.js';
import {scoresOf, type Scores} from './scores.js';

/** Two edges, by number. */
type Pair = readonly [number, number];

/** A seam from corner to corner. */
export interface WholeSeam {
  /** Its parts along the first side: edges that are sewn to each other. */
  readonly pairs: readonly (readonly [EdgeOfPiece, EdgeOfPiece])[];
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

/** Likelihoods of pairs of open edges. */
interface Pairs {
  /** Likelihood that the seam is right, or right after pieces of equal shape change places. */
  readonly of: (pair: Pair) => number;
  /** The likeliest partner of each edge, or -1. */
  readonly best: Int32Array;
}

/** Returns the edges that are on pieces without a seam to another piece. */
function looseEdges({garment}: Scores, {seams}: GarmentDocument): (edge: number) => boolean {
  const bound = new Set(
    seams.flatMap(({a, b}) => (a.piece === b.piece ? [] : [a.piece, b.piece])),
  );
  return (edge) => !bound.has(garment.edges[edge]?.at.piece ?? -1);
}

/** Distance of two pieces in a numbered row. */
const distanceOf = ({garment: {edges, pieces}}: Scores, a: number, b: number): number => {
  const [one, other] = [a, b].map((edge) => pieces[edges[edge]?.at.piece ?? -1]?.words.number);
  return Math.abs((one ?? 0) - (other ?? 0));
};

/** Likelihoods that differ by less are equal: twin pieces differ by rounding. */
const rounding = 0.02;

function pairsIn(scores: Scores, document: GarmentDocument): Pairs {
  const {
    likelihoods: {size, values},
    isFree,
  } = scores;
  const isLoose = looseEdges(scores, document);
  const copies = copiesOf(scores.garment).map((all, edge) => (isLoose(edge) ? all : [edge]));
  const own = (a: number, b: number): number => values[a * size + b] ?? 0;
  const sum = (a: number, b: number): number =>
    (copies[b] ?? []).reduce((total, copy) => total + own(a, copy), 0);
  const of = ([a, b]: Pair): number => Math.min(1, Math.max(sum(a, b), sum(b, a)));
  const best = Int32Array.from(isFree, (_, a) => {
    let [found, most] = [-1, 0];
    for (let b = 0; b < size; b++) {
      if (isFree[a] !== 1 || isFree[b] !== 1 || own(a, b) === 0) continue;
      const p = of([a, b]) + 0.1 * own(a, b);
      const isNearer = found >= 0 && distanceOf(scores, a, b) < distanceOf(scores, a, found);
      if (p > most + rounding || (p > most - rounding && isNearer)) [found, most] = [b, p];
    }
    return found;
  });
  return {of, best};
}

/** Adds the parts beyond the end of a seam's first side, as far as both boundaries go straight on. */
function extended({of}: Pairs, boundary: Boundary, pairs: readonly Pair[]): readonly Pair[] {
  const all = [...pairs];
  const used = new Set(pairs.flat());
  for (;;) {
    const [a = -1, b = -1] = all.at(-1) ?? [];
    const [next, other] = [boundary.after(a), boundary.before(b)];
    if (!next || !other || !isStraight(next) || !isStraight(other)) return all;
    const pair: Pair = [next.edge, other.edge];
    if (next.edge === other.edge || used.has(next.edge) || used.has(other.edge)) return all;
    if (of(pair) < leastPart) return all;
    all.push(pair);
    pair.forEach((edge) => used.add(edge));
  }
}

const turned = (pairs: readonly Pair[]): readonly Pair[] =>
  pairs.map(([a, b]): Pair => [b, a]).reverse();

/** Returns whether one side goes straight on where the other ends, as at a piece that is missing. */
function isUneven(boundary: Boundary, [a, b]: Pair): boolean {
  const goesOn = [boundary.after(a), boundary.before(b)].map((step) => step && isStraight(step));
  return goesOn[0] !== goesOn[1];
}

const logit = (p: number): number => Math.log((p + 1e-4) / (1 - p + 1e-4));

/** Subtracted from the log odds for each uneven end. */
const doubt = Number((globalThis as any).process?.env?.DOUBT ?? 0.7);

/** Returns the likelihood of a seam: its parts weighted by their length. */
function wholeLikelihood({garment: {edges}}: Scores, {of}: Pairs, pairs: readonly Pair[], uneven: number): number {
  let [sum, total] = [0, 0];
  for (const pair of pairs) {
    const length = (edges[pair[0]]?.length ?? 0) + (edges[pair[1]]?.length ?? 0);
    sum += length * logit(of(pair));
    total += length;
  }
  return 1 / (1 + Math.exp(uneven * doubt - sum / total));
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
  const pairsOf = pairsIn(scores, garment);
  const seeds = [...pairsOf.best.entries()]
    .map(([a, b]) => ({a, b, p: b < 0 ? 0 : pairsOf.of([a, b])}))
    .filter(({a, b, p}) => p >= least && (a < b || pairsOf.best[b] !== a))
    .sort((one, other) => other.p - one.p);
  const used = new Set<number>();
  const found: WholeSeam[] = [];
  for (const {a, b} of seeds) {
    if (used.has(a) || used.has(b)) continue;
    const onwards = extended(pairsOf, boundary, [[a, b]]);
    const pairs = turned(extended(pairsOf, boundary, turned(onwards)));
    const own = pairs.filter((pair) => pair.every((edge) => !used.has(edge)));
    own.flat().forEach((edge) => used.add(edge));
    const [head, tail] = [own[0], own.at(-1)];
    if (!head || !tail) continue;
    const uneven =
      Number(isUneven(boundary, tail)) + Number(isUneven(boundary, [head[1], head[0]]));
    const place = placeOf(scores.garment, a, b);
    const ends = own.map(([one, other]) => [edgeAt(scores, one), edgeAt(scores, other)] as const);
    const [from, to] = [edgeAt(scores, a), edgeAt(scores, b)];
    found.push({
      pairs: ends,
      place,
      p: wholeLikelihood(scores, pairsOf, own, uneven),
      sameDirection: meetsAtStarts(garment, from, to),
    });
  }
  return found.sort((one, other) => rankOf(one) - rankOf(other) || other.p - one.p);
}

/** Likelihood from which the order of sewing decides. */
const likely = Number((globalThis as any).process?.env?.LIKELY ?? 0.8);

/** Returns the step at which a seam is asked about: likely seams in the order of sewing. */
const rankOf = ({place, p}: WholeSeam): number => (p >= likely ? stepOf(place) : 10);

