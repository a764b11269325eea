/** The user's state of a layout: choices about the fabric, pins, and flaws to avoid. */
import type {MarkerTexts} from '../../texts/marker-texts.js';
import type {MarkerOrder} from '../../marker/problem.js';
import type {Failure} from '../../model/base/failure.js';
import type {Alignment, Point} from '../../model/geometry/vectors.js';
import type {LayPlan} from '../../model/result/marker-plan.js';
import type {MarkerProblem} from '../../model/result/marker-search.js';
import type {MarkerChoices} from './marker-choices.js';

export type Flaw = readonly Point[];

/** State that undo restores. Pieces are given by their numbers. */
export interface LayStep {
  readonly choices: MarkerChoices;
  /** Polygons of the fabric that pieces must avoid. */
  readonly flaws: readonly Flaw[];
  readonly pins: ReadonlySet<number>;
  /** Places of pieces; undefined for a piece without one. */
  readonly places: readonly (Alignment | undefined)[];
  /** Order of the last layout; undefined before the first. */
  readonly order: MarkerOrder | undefined;
  /** Plan of the last layout; undefined before the first. */
  readonly plan: LayPlan | undefined;
  /** Failure of the last layout. */
  readonly failure: Failure | undefined;
}

export const noPins: LayStep['pins'] = new Set();

/** Returns whether the fabric is on the table already, which flaws or pinned pieces imply. */
export const liesThere = ({pins, flaws}: LayStep): boolean => pins.size > 0 || flaws.length > 0;

/** Adds pins and flaws to a problem. The print keeps its place if the fabric is on the table. */
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

function changeBetween(from: LayStep, to: LayStep): keyof MarkerTexts['steps'] {
  if (from.choices !== to.choices) return 'fabric';
  if (from.flaws !== to.flaws) return 'flaw';
  const count = ({places}: LayStep): number => places.filter((one) => one !== undefined).length;
  if (from.plan === to.plan && count(to) < count(from)) return 'remove';
  if (from.pins !== to.pins) return 'pin';
  if (from.plan !== to.plan || from.places === to.places) return 'pack';
  const isTurned = to.places.some((place, k) => place?.angle !== from.places[k]?.angle);
  return isTurned ? 'turn' : 'move';
}

/** Name of a step of the history. Returns undefined if there is no step. */
export const layStepWords = (
  from: LayStep | undefined,
  to: LayStep | undefined,
  {steps}: MarkerTexts,
): string | undefined => from && to && steps[changeBetween(from, to)];
