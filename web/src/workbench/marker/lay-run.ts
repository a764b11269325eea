/** Lays out a result on its fabric while the page stays responsive. */
import type {MarkerGarment} from '../../model/design/marker-garment.js';
import {cheaperLays, type CheaperMeans} from '../../marker/cheaper.js';
import {cutRings, cutRingSteps} from '../../marker/cut-rings.js';
import {withOptions} from '../../marker/designs.js';
import {layPlan} from '../../marker/plan.js';
import {markerOrder, type MarkerOrder} from '../../marker/problem.js';
import type {MarkerSettings} from '../../marker/settings.js';
import {unlessFailed} from '../../marker/shifted.js';
import type {Design} from '../../model/design/design.js';
import {problemOf} from '../../model/documents/design-problem.js';
import type {GarmentDocument} from '../../model/garment/garment-document.js';
import {failureOf, SolverError} from '../../model/base/failure.js';
import type {LayPlan} from '../../model/result/marker-plan.js';
import type {SolveResult} from '../../model/result/result.js';
import {besideThePage, runInSlices, stepsFor} from '../../solver/answers/slices.js';
import {askedOf, liesThere, type LayStep} from './lay-step.js';
import type {Workbench} from '../workbench.js';

/** Input of a layout: a result and its fabric. */
export interface ToLay {
  readonly design: Design;
  readonly result: SolveResult;
  readonly garment: GarmentDocument;
  readonly step: LayStep;
}

interface LayHooks {
  readonly signal: AbortSignal;
  readonly onProgress: (fraction: number) => void;
  /** Receives each plan that is better than those before, and the last one. */
  readonly onPlan: (order: MarkerOrder, plan: LayPlan) => void;
}

interface Asked {
  readonly garments: readonly [MarkerGarment];
  readonly settings: MarkerSettings;
  readonly print: Design['print'];
}

function askedFor({design, result, garment, step: {choices}}: ToLay): Asked {
  const {options, names, print} = design;
  const {isOneWay, phaseCm, ...fabric} = choices;
  return {
    garments: [{result, garment, options, ...(names && {names})}],
    settings: {
      ...fabric,
      ...(phaseCm !== null && {phaseCm}),
      ...(isOneWay && {nap: 'one-way' as const}),
    },
    print,
  };
}

/** Edges of a garment that have an allowance of their own. */
export function ownAllowancesOf(toLay: ToLay): ReturnType<typeof cutRings>['ownAllowances'] {
  const {garments, settings} = askedFor(toLay);
  return cutRings(garments[0], ruleOf(settings)).ownAllowances;
}

const ruleOf = ({allowanceCm = 0, hemCm = allowanceCm}: MarkerSettings) => ({allowanceCm, hemCm});

/**
 * Lays out a result.
 * @throws {SolverError} naming cause and remedy, if no layout is possible; the signal's reason
 */
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
  const answer = await solver
    .marker(problem, {
      signal,
      onProgress: ({fraction}) => {
        if (!signal.aborted) onProgress(fraction);
      },
      onLayout: (layout) => {
        if (!signal.aborted) onPlan(order, layPlan(asked, layout));
      },
    })
    .catch((error: unknown) => {
      throw error instanceof SolverError ? ofGarment(error, order, toLay) : error;
    });
  signal.throwIfAborted();
  onPlan(order, layPlan(asked, answer));
}

/** A failure with the index of its piece in the garment in place of that among the laid pieces. */
function ofGarment(failure: SolverError, {pieces}: MarkerOrder, {result}: ToLay): SolverError {
  const name = pieces[failure.piece ?? -1]?.piece;
  const piece = result.pieces.findIndex((one) => one.name === name);
  return new SolverError({...failureOf(failure), piece: piece < 0 ? null : piece});
}

/**
 * Changes that would take less fabric than a plan. There are none for fabric on the table, because
 * its print and pins are fixed.
 */
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

/**
 * Adds the other designs that the garment's search has compared. The search is cached, so this
 * takes little time.
 */
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
