/** What is laid on cloth as somebody has it: how the cloth is, what is pinned, what is to be left out. */
import {markerOrder, type MarkerOrder} from '../marker/problem.js';
import type {Design} from '../model/design.js';
import type {Failure} from '../model/failure.js';
import type {GarmentDocument} from '../model/garment-document.js';
import type {Alignment, Point} from '../model/geometry.js';
import type {LayPlan} from '../model/lay-plan.js';
import type {MarkerProblem} from '../model/marker.js';
import type {SolveResult} from '../model/result.js';
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
  /** As it was laid last; undefined before. */
  readonly plan: LayPlan | undefined;
  /** Why it could not be laid. */
  readonly failure: Failure | undefined;
}

export const noPins: LayStep['pins'] = new Set();

/** @throws {SolverError} for what cannot be laid at all, naming what and the remedy */
export function orderOf(
  {options, names, print}: Design,
  result: SolveResult,
  garment: GarmentDocument,
  {widthCm, selvedgeCm, gapCm, isOneWay, phaseCm}: ClothChoices,
): MarkerOrder {
  return markerOrder(
    [{result, garment, options, ...(names && {names})}],
    {
      ...{widthCm, selvedgeCm, gapCm},
      ...(phaseCm !== null && {phaseCm}),
      ...(isOneWay && {nap: 'one-way'}),
    },
    print,
  );
}

/** With flaws or pinned pieces the cloth is one that lies there: where its print is stays. */
export function askedOf(
  problem: MarkerProblem,
  {pins, flaws, places, plan, choices}: LayStep,
): MarkerProblem {
  const origin = plan?.printOrigin;
  if (!origin || (pins.size === 0 && flaws.length === 0)) return {...problem, flaws};
  return {
    ...problem,
    ...{flaws, phasesCm: [choices.phaseCm ?? origin[0]], startCm: origin[1]},
    pieces: problem.pieces.map((piece, k) => {
      const pin = pins.has(k) ? places[k] : undefined;
      return pin ? {...piece, pin} : piece;
    }),
  };
}
