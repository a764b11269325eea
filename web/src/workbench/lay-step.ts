/** What is laid on cloth as somebody has it: how the cloth is, what is pinned, what is to be left out. */
import {cheaperLays} from '../marker/cheaper.js';
import {markerOrder, type MarkerOrder} from '../marker/problem.js';
import type {Design} from '../model/design.js';
import type {Failure} from '../model/failure.js';
import type {GarmentDocument} from '../model/garment-document.js';
import type {Alignment, Point} from '../model/geometry.js';
import type {LayPlan} from '../model/lay-plan.js';
import type {MarkerProblem} from '../model/marker.js';
import type {SolveResult} from '../model/result.js';
import type {ClothChoices} from './cloth-choices.js';
import type {Workbench} from './workbench.js';

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

/** What is laid of an answer, and on what. */
interface ToLay {
  readonly design: Design;
  readonly result: SolveResult;
  readonly garment: GarmentDocument;
  readonly choices: ClothChoices;
}

function askedFor({design, result, garment, choices}: ToLay) {
  const {options, names, print} = design;
  const {widthCm, selvedgeCm, gapCm, isOneWay, phaseCm} = choices;
  return {
    garments: [{result, garment, options, ...(names && {names})}],
    settings: {
      ...{widthCm, selvedgeCm, gapCm},
      ...(phaseCm !== null && {phaseCm}),
      ...(isOneWay && {nap: 'one-way' as const}),
    },
    print,
  };
}

/** @throws {SolverError} for what cannot be laid at all, naming what and the remedy */
export function orderOf(toLay: ToLay): MarkerOrder {
  const {garments, settings, print} = askedFor(toLay);
  return markerOrder(garments, settings, print);
}

/** What would take less cloth than a plan. */
export const offersFor = (
  toLay: ToLay,
  plan: LayPlan,
  solver: Workbench['solver'],
  signal: AbortSignal,
): Promise<LayPlan['cheaper']> =>
  cheaperLays({...askedFor(toLay), plan}, {lay: (problem, hooks) => solver.marker(problem, hooks)}, {
    signal,
  });

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
