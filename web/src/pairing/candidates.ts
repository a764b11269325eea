/** The pairs of edges that may be sewn to each other, with what is known of each. */
import {featuresOf, type Surroundings} from './features.js';
import {beliefsOf, jointFeatures, type Beliefs} from './joints.js';
import {matchingLikelihoods, tableOf} from './matching.js';

export interface Candidates {
  readonly surroundings: Surroundings;
  /** Each by the numbers of its edges, the greater one first. */
  readonly pairs: readonly (readonly [number, number])[];
  /** Of each what the edges have in common by themselves. */
  readonly features: readonly (readonly number[])[];
}

/** No gathers are tighter: as a ratio of lengths. */
const tightest = 6;

/**
 * All pairs but those whose lengths are too far apart.
 * @param mayBe whether two edges may be sewn to each other
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

/** Candidates that are as good as impossible. */
const hopeless = -6;
/** As many of the likeliest that each edge keeps all the same. */
const kept = 12;

/**
 * Without those that nothing of the neighbours could make likely: four of five.
 * @param logOdds of each candidate
 */
export function hopeful(candidates: Candidates, logOdds: readonly number[]): Candidates {
  const {surroundings, pairs, features} = candidates;
  const ofEdge = surroundings.garment.edges.map((): number[] => []);
  for (const [k, ends] of pairs.entries())
    for (const end of ends) ofEdge[end]?.push(logOdds[k] ?? 0);
  // twins differ by rounding
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
 * What to believe of all seams.
 * @param logOdds of each candidate, taken by itself
 * @param sewn pairs that are confirmed
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

/** Of each candidate all features: by themselves, and given what is believed. */
export const givenBeliefs = (
  {surroundings, pairs, features}: Candidates,
  beliefs: Beliefs,
): readonly (readonly number[])[] =>
  pairs.map(([i, j], k) => [...(features[k] ?? []), ...jointFeatures(surroundings, beliefs, i, j)]);
