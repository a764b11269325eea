/** Likelihoods of pairs of open edges, as a person would judge them who sees the whole garment. */
import {DisjointSets} from './disjoint-sets.js';
import type {GarmentDocument} from '../model/garment/garment-document.js';
import {copiesOf} from './congruent.js';
import {areNeighbours} from './names.js';
import type {Scores} from './scores.js';

/** Two edges, by number. */
export type Pair = readonly [number, number];

export interface LikelyPairs {
  /** Likelihood that the seam is right, or right after pieces of equal shape change places. */
  readonly of: (pair: Pair) => number;
  /** The likeliest partner of each edge, or -1. */
  readonly best: Int32Array;
}

/** Returns the edges that are on pieces without a seam to another piece. */
function looseEdges({garment}: Scores, {seams}: GarmentDocument): (edge: number) => boolean {
  const bound = new Set(seams.flatMap(({a, b}) => (a.piece === b.piece ? [] : [a.piece, b.piece])));
  return (edge) => !bound.has(garment.edges[edge]?.at.piece ?? -1);
}

/** Distance of two pieces in a numbered row. */
const distanceOf = ({garment: {edges, pieces}}: Scores, a: number, b: number): number => {
  const [one, other] = [a, b].map((edge) => pieces[edges[edge]?.at.piece ?? -1]?.words.number);
  return Math.abs((one ?? 0) - (other ?? 0));
};

/** Likelihoods that differ by less are equal: twin pieces differ by rounding. */
const rounding = 0.02;

/** Adds this to the log odds of a seam that joins a separate part to the garment. */
const connecting = 3.5;
/** Ratio to the next likelihood of the same edges above which such a seam is meant. */
const margin = 2;

/**
 * Returns whether a seam joins two parts that are not sewn to each other, of the same kind, of
 * neighbours or of an unknown kind: a garment is one whole.
 */
function joinTest(
  {garment, likelihoods: {size, values}}: Scores,
  {pieces, seams}: GarmentDocument,
): (pair: Pair) => boolean {
  const parts = new DisjointSets(pieces.length);
  for (const {a, b} of seams) parts.join(a.piece, b.piece);
  const isBest = (a: number, b: number): boolean => {
    const row = values.subarray(a * size, (a + 1) * size);
    const own = row[b] ?? 0;
    return row.every((p, other) => other === b || p * margin <= own);
  };
  return ([a, b]) => {
    const [p, q] = [garment.edges[a]?.at.piece ?? 0, garment.edges[b]?.at.piece ?? 0];
    const [one, other] = [garment.pieces[p], garment.pieces[q]];
    if (!one || !other || parts.find(p) === parts.find(q)) return false;
    const kinds = [one.words.kind, other.words.kind] as const;
    const mayJoin = kinds[0] === kinds[1] || kinds.includes(undefined) || areNeighbours(...kinds);
    return mayJoin && isBest(a, b) && isBest(b, a);
  };
}

/** @param joins raises the likelihoods of seams that join separate parts */
export function likelyPairs(
  scores: Scores,
  document: GarmentDocument,
  joins: boolean,
): LikelyPairs {
  const {
    likelihoods: {size, values},
    isFree,
  } = scores;
  const isLoose = looseEdges(scores, document);
  const copies = copiesOf(scores.garment).map((all, edge) => (isLoose(edge) ? all : [edge]));
  const isJoin = joins ? joinTest(scores, document) : () => false;
  const own = (a: number, b: number): number => {
    const p = values[a * size + b] ?? 0;
    return p > 0 && isJoin([a, b]) ? 1 / (1 + (1 / p - 1) * Math.exp(-connecting)) : p;
  };
  const sum = (a: number, b: number): number =>
    (copies[b] ?? []).reduce((total, copy) => total + own(a, copy), 0);
  const of = ([a, b]: Pair): number => Math.min(1, Math.max(sum(a, b), sum(b, a)));
  const best = Int32Array.from(isFree, (_, a) => {
    let [found, most] = [-1, 0];
    for (let b = 0; b < size; b++) {
      const p0 = values[a * size + b] ?? 0;
      if (isFree[a] !== 1 || isFree[b] !== 1 || p0 === 0) continue;
      const p = of([a, b]) + 0.1 * p0;
      const isNearer = found >= 0 && distanceOf(scores, a, b) < distanceOf(scores, a, found);
      if (p > most + rounding || (p > most - rounding && isNearer)) [found, most] = [b, p];
    }
    return found;
  });
  return {of, best};
}
