/** Candidate pairs of edges that may be sewn together, with their features. */
import {featuresOf, type Surroundings} from './features.js';
import {beliefsOf, jointFeatures, type Beliefs} from './joints.js';
import {matchingLikelihoods, tableOf} from './matching.js';

export interface Candidates {
  readonly surroundings: Surroundings;
  /** Edge numbers of each pair, the greater one first. */
  readonly pairs: readonly (readonly [number, number])[];
  /** Features of each pair that depend on its two edges only. */
  readonly features: readonly (readonly number[])[];
}

/** Greatest ratio of two lengths: no seam is gathered more tightly. */
const tightest = 6;

/**
 * Returns all pairs of edges except those with too different lengths.
 * @param mayBe returns whether two edges may be sewn together
 */
export function candidatesOf(
  surroundings: Surroundings,
  mayBe: (i: number, j: number) => boolean,
): Candidates {
  const {edges} = surroundings.garment;
  const pairs: [number, number][] = [];
  for (const [i, a] of edges.entries()) {
    for (const [j, b] of edges.entries()) {
      if (j >= i) break;
      const ratio = a.length / b.length;
      if (ratio < tightest && ratio > 1 / tightest && mayBe(i, j)) pairs.push([i, j]);
    }
  }
  return {surroundings, pairs, features: pairs.map(([i, j]) => featuresOf(surroundings, i, j))};
}

/** Log odds below which a candidate is dropped. */
const hopeless = -6;
/** Number of the likeliest candidates that each edge keeps even below that limit. */
const kept = 12;

/**
 * Drops the candidates that no neighbour could make likely: four of five.
 * @param logOdds one value for each candidate
 */
export function hopeful(candidates: Candidates, logOdds: readonly number[]): Candidates {
  const {surroundings, pairs, features} = candidates;
  const ofEdge = surroundings.garment.edges.map((): number[] => []);
  for (const [k, ends] of pairs.entries())
    for (const end of ends) ofEdge[end]?.push(logOdds[k] ?? 0);
  // the values of twin pieces differ by rounding
  const limits = ofEdge.map((all) => (all.sort((a, b) => b - a)[kept - 1] ?? -Infinity) - 1e-6);
  const isKept = pairs.map(([i, j], k) => {
    const own = logOdds[k] ?? 0;
    return own >= Math.min(hopeless, limits[i] ?? 0, limits[j] ?? 0);
  });
  return {
    surroundings,
    pairs: pairs.filter((_, k) => isKept[k]),
    features: features.filter((_, k) => isKept[k]),
  };
}

/**
 * Returns the beliefs about all seams.
 * @param logOdds one value for each candidate, from its own features
 * @param sewn confirmed pairs
 */
export function believed(
  {surroundings, pairs}: Candidates,
  logOdds: readonly number[],
  sewn: readonly (readonly [number, number])[],
): Beliefs {
  const {edges} = surroundings.garment;
  const odds = tableOf(edges.length);
  const put = (table: Float64Array, i: number, j: number, value: number): void => {
    table[i * edges.length + j] = value;
    table[j * edges.length + i] = value;
  };
  for (const [k, [i, j]] of pairs.entries()) {
    put(odds.values, i, j, Math.exp(Math.max(-12, Math.min(12, logOdds[k] ?? 0))));
  }
  const likelihoods = matchingLikelihoods(odds);
  for (const [i, j] of sewn) put(likelihoods.values, i, j, 1);
  return beliefsOf(surroundings, likelihoods, (2 * sewn.length) / edges.length);
}

/** Returns all features of each candidate: its own, and those that depend on the beliefs. */
export const givenBeliefs = (
  {surroundings, pairs, features}: Candidates,
  beliefs: Beliefs,
): readonly (readonly number[])[] =>
  pairs.map(([i, j], k) => [...(features[k] ?? []), ...jointFeatures(surroundings, beliefs, i, j)]);
