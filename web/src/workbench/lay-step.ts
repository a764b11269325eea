/** What is laid on cloth as somebody has it: how the cloth is, what is pinned, what is to be left out. */
import type {MarkerOrder} from '../marker/problem.js';
import type {Failure} from '../model/failure.js';
import type {Alignment, Point} from '../model/geometry.js';
import type {LayPlan} from '../model/lay-plan.js';
import type {MarkerProblem} from '../model/marker.js';
import type {ClothChoices} from './cloth-choices.js';

export type Flaw = readonly Point[];

/** What undo comes back to. Pieces are meant by their numbers. */
export interface LayStep {
  readonly choices: ClothChoices;
  /** Polygons of the cloth on which nothing may lie. */
  readonly flaws: readonly Flaw[];
  readonly pins: ReadonlySet<number>;
  /** Undefined where one has none. */
  readonly places: readonly (Alignment | undefined)[];
  /** What was laid last; undefined before. */
  readonly order: MarkerOrder | undefined;
  /** As it was laid last; undefined before. */
  readonly plan: LayPlan | undefined;
  /** Why it could not be laid. */
  readonly failure: Failure | undefined;
}

export const noPins: LayStep['pins'] = new Set();

/** With flaws or pinned pieces the cloth is one that lies there. */
export const liesThere = ({pins, flaws}: LayStep): boolean => pins.size > 0 || flaws.length > 0;

/** On cloth that lies there its print stays where it is. */
export function askedOf(problem: MarkerProblem, step: LayStep): MarkerProblem {
  const {pins, flaws, places, plan, choices} = step;
  const origin = plan?.printOrigin;
  if (!origin || !liesThere(step)) return {...problem, flaws};
  return {
    ...problem,
    ...{flaws, phasesCm: [choices.phaseCm ?? origin[0]], startCm: origin[1]},
    pieces: problem.pieces.map((piece, k) => {
      const pin = pins.has(k) ? places[k] : undefined;
      return pin ? {...piece, pin} : piece;
    }),
  };
}
