/** Searches longer for a better answer to a solved design, with other seeds. */
import type {Design} from '../model/design/design.js';
import {IdleSearch, type VariantSearch} from './idle-search.js';
import {betterThan} from './idle-solver.js';

/** An answer of another seed that makes more visible seams match. */
export interface BetterMatch {
  readonly seed: number;
  /** Number of further visible seams that match. */
  readonly gained: number;
}

const sameRepeat = ({print: one}: Design, {print: other}: Design): boolean =>
  one.turnDeg === other.turnDeg &&
  (['width', 'height', 'angleDeg'] as const).every((side) => one.size[side] === other.size[side]);

export class LongerSearch extends IdleSearch {
  /** The best answer so far, if it is better than that of the design. */
  better(design: Design): BetterMatch | undefined {
    const {known} = this.solver;
    const present = known.of(design);
    const others = known.all(design).filter((one) => sameRepeat(one.design, design));
    const best = betterThan(present, others);
    if (!best || !present) return undefined;
    const gained = best.standing.matched - present.standing.matched;
    return {seed: best.design.seed, gained};
  }

  protected override searches(design: Design): readonly VariantSearch[] {
    // other methods take the seed for random starts
    if (design.method !== 'best') return [];
    return [
      {
        ...{scales: [1], turns: [0], isLong: true},
        seed: this.solver.known.firstSeed(design),
        designOf: (_, seed) => ({...design, seed}),
      },
    ];
  }
}
