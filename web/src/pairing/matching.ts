/**
 * Turns odds of pairs into likelihoods under the constraint that each edge is sewn once at most.
 */

/** Square table of numbers, row by row. */
export interface Table {
  readonly size: number;
  readonly values: Float64Array;
}

export const tableOf = (size: number): Table => ({size, values: new Float64Array(size * size)});

const rounds = 12;

/**
 * Turns independent odds of pairs into likelihoods of pairs in matchings, by belief propagation:
 * each message is the likelihood that an edge is free for another.
 * @param odds symmetric; 0 for impossible pairs
 */
export function matchingLikelihoods({size, values: odds}: Table): Table {
  let free = new Float64Array(size * size).fill(1);
  let next = new Float64Array(size * size);
  for (let round = 0; round < rounds; round++) {
    for (let i = 0; i < size; i++) {
      const row = i * size;
      let sum = 1;
      for (let j = 0; j < size; j++) sum += (odds[row + j] ?? 0) * (free[j * size + i] ?? 0);
      for (let j = 0; j < size; j++) {
        const own = (odds[row + j] ?? 0) * (free[j * size + i] ?? 0);
        // damped by half, since two rounds could alternate forever
        next[row + j] = 0.5 * (free[row + j] ?? 0) + 0.5 / (sum - own);
      }
    }
    [free, next] = [next, free];
  }
  const likelihoods = tableOf(size);
  for (let i = 0; i < size; i++) {
    for (let j = 0; j < i; j++) {
      const [k, other] = [i * size + j, j * size + i];
      const weight = (odds[k] ?? 0) * (free[k] ?? 0) * (free[other] ?? 0);
      likelihoods.values[k] = weight / (1 + weight);
      likelihoods.values[other] = weight / (1 + weight);
    }
  }
  return likelihoods;
}
