/** An answer laid on its cloth, beside a page that goes on. */
import {cheaperLays, type CheaperMeans} from '../marker/cheaper.js';
import {cutRings, cutRingSteps, type MarkerGarment} from '../marker/cut-rings.js';
import {withOptions} from '../marker/designs.js';
import {layPlan} from '../marker/plan.js';
import {markerOrder, type MarkerOrder} from '../marker/problem.js';
import type {MarkerSettings} from '../marker/settings.js';
import {unlessFailed} from '../marker/shifted.js';
import type {Design} from '../model/design.js';
import {problemOf} from '../model/design-problem.js';
import type {GarmentDocument} from '../model/garment-document.js';
import type {LayPlan} from '../model/lay-plan.js';
import type {SolveResult} from '../model/result.js';
import {besideThePage, runInSlices, stepsFor} from '../solver/answers/slices.js';
import {askedOf, liesThere, type LayStep} from './lay-step.js';
import type {Workbench} from './workbench.js';

/** What is laid of an answer, and on what. */
export interface ToLay {
  readonly design: Design;
  readonly result: SolveResult;
  readonly garment: GarmentDocument;
  readonly step: LayStep;
}

interface LayHooks {
  readonly signal: AbortSignal;
  readonly onProgress: (fraction: number) => void;
  /** Hears of each plan that is better than those before, and of the last one. */
  readonly onPlan: (order: MarkerOrder, plan: LayPlan) => void;
}

interface Asked {
  readonly garments: readonly [MarkerGarment];
  readonly settings: MarkerSettings;
  readonly print: Design['print'];
}

function askedFor({design, result, garment, step: {choices}}: ToLay): Asked {
  const {options, names, print} = design;
  const {isOneWay, phaseCm, ...cloth} = choices;
  return {
    garments: [{result, garment, options, ...(names && {names})}],
    settings: {
      ...cloth,
      ...(phaseCm !== null && {phaseCm}),
      ...(isOneWay && {nap: 'one-way' as const}),
    },
    print,
  };
}

/** Which edges of a garment have an allowance of their own. */
export function ownAllowancesOf(toLay: ToLay): ReturnType<typeof cutRings>['ownAllowances'] {
  const {garments, settings} = askedFor(toLay);
  return cutRings(garments[0], ruleOf(settings)).ownAllowances;
}

const ruleOf = ({allowanceCm = 0, hemCm = allowanceCm}: MarkerSettings) => ({allowanceCm, hemCm});

/** @throws {SolverError} for what cannot be laid at all, naming what and the remedy; the signal's reason */
export async function laid(
  toLay: ToLay,
  solver: Workbench['solver'],
  {signal, onProgress, onPlan}: LayHooks,
): Promise<void> {
  const {garments, settings, print} = askedFor(toLay);
  const rings = cutRingSteps(garments[0], ruleOf(settings));
  const step = (): boolean => rings.next().done !== true;
  await runInSlices((time) => stepsFor(time, step), besideThePage, signal);
  const order = markerOrder(garments, settings, print);
  const problem = askedOf(order.problem, toLay.step);
  const asked = {...order, problem};
  const answer = await solver.marker(problem, {
    signal,
    onProgress: ({fraction}) => {
      if (!signal.aborted) onProgress(fraction);
    },
    onLayout: (layout) => {
      if (!signal.aborted) onPlan(order, layPlan(asked, layout));
    },
  });
  signal.throwIfAborted();
  onPlan(order, layPlan(asked, answer));
}

/** What would take less cloth than a plan; nothing of cloth that lies there, of which nothing is to be chosen any more. */
export async function offersFor(
  toLay: ToLay,
  plan: LayPlan,
  solver: Workbench['solver'],
  signal: AbortSignal,
): Promise<LayPlan['cheaper']> {
  if (liesThere(toLay.step)) return [];
  const asked = askedFor(toLay);
  const means: CheaperMeans = {
    lay: (problem, hooks) => solver.marker(problem, hooks),
    solve: (problem, hooks) => solver.solve(problem, hooks),
  };
  const garment = await withOthers(asked.garments[0], toLay.design, solver, signal);
  const offers = await cheaperLays({...asked, garments: [garment], plan}, means, {signal});
  signal.throwIfAborted();
  return offers;
}

/** With the other designs that its search has compared: the search itself is remembered, so that this takes little. */
async function withOthers(
  garment: MarkerGarment,
  design: Design,
  solver: Workbench['solver'],
  signal: AbortSignal,
): Promise<MarkerGarment> {
  const seek = async (): Promise<MarkerGarment> => {
    const problem = problemOf(design);
    const asked = withOptions(problem, {otherAlignments: true});
    const {otherAlignments: others = []} = await solver.solve(asked, {signal});
    return {...garment, problem, others};
  };
  return (await unlessFailed(seek(), signal)) ?? garment;
}
