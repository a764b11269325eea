/** Lays out garments on their fabric while the page stays responsive. */
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
import {failureOf, SolverError} from '../../model/base/failure.js';
import type {LayPlan} from '../../model/result/marker-plan.js';
import {besideThePage, runInSlices, stepsFor} from '../../solver/answers/slices.js';
import type {OwnShare} from '../../cutting/allowances.js';
import type {SolvedGarment} from './added-results.js';
import {askedOf, liesThere, type LayStep} from './lay-step.js';
import type {Workbench} from '../workbench.js';

/** Input of a layout: the garments and their fabric. */
export interface ToLay {
  /** The design's own garment first, then those that were added. */
  readonly garments: readonly SolvedGarment[];
  readonly print: Design['print'];
  readonly step: LayStep;
}

interface LayHooks {
  readonly signal: AbortSignal;
  readonly onProgress: (fraction: number) => void;
  /** Receives each plan that is better than those before, and the last one. */
  readonly onPlan: (order: MarkerOrder, plan: LayPlan) => void;
}

interface Asked {
  readonly garments: readonly MarkerGarment[];
  readonly settings: MarkerSettings;
  readonly print: Design['print'];
}

/** A garment for the layout. Its file is only named beside others. */
export const markerGarmentOf = (
  {design: {garment, options, names}, copies, result, document}: SolvedGarment,
  isOnly = true,
): MarkerGarment => ({
  ...{result, garment: document, options, copies},
  ...(names && {names}),
  ...(!isOnly && {name: garment.name}),
});

function askedFor({garments, print, step: {choices}}: ToLay): Asked {
  const {isOneWay, phaseCm, widthCm, selvedgeCm, gapCm, allowanceCm, hemCm} = choices;
  const fabric = {widthCm, selvedgeCm, gapCm, allowanceCm, hemCm};
  return {
    garments: garments.map((one) => markerGarmentOf(one, garments.length === 1)),
    settings: {
      ...fabric,
      ...(phaseCm !== null && {phaseCm}),
      ...(isOneWay && {nap: 'one-way' as const}),
    },
    print,
  };
}

/** Edges of the garments that have an allowance of their own. */
export function ownAllowancesOf(toLay: ToLay): OwnShare {
  const {garments, settings} = askedFor(toLay);
  const shares = garments.map((one) => cutRings(one, ruleOf(settings)).ownAllowances);
  const [first = 'none'] = shares;
  return shares.every((share) => share === first) ? first : 'some';
}

const ruleOf = ({allowanceCm = 0, hemCm = allowanceCm}: MarkerSettings) => ({allowanceCm, hemCm});

/**
 * Lays out garments.
 * @throws {SolverError} naming cause and remedy, if no layout is possible; the signal's reason
 */
export async function laid(
  toLay: ToLay,
  solver: Workbench['solver'],
  {signal, onProgress, onPlan}: LayHooks,
): Promise<void> {
  const {garments, settings, print} = askedFor(toLay);
  for (const garment of garments) {
    const rings = cutRingSteps(garment, ruleOf(settings));
    const step = (): boolean => rings.next().done !== true;
    await runInSlices((time) => stepsFor(time, step), besideThePage, signal);
  }
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

/**
 * A failure with the index of its piece in the design's garment in place of that among the laid
 * pieces; null for a piece of another garment, which the message names.
 */
function ofGarment(failure: SolverError, {pieces}: MarkerOrder, {garments}: ToLay): SolverError {
  const {piece: name, result: which} = pieces[failure.piece ?? -1] ?? {};
  const own = which === 0 ? garments[0]?.result.pieces : undefined;
  const piece = own?.findIndex((one) => one.name === name) ?? -1;
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
  const [own, ...added] = asked.garments;
  const [first] = toLay.garments;
  if (!own || !first) return [];
  const garment = await withOthers(own, first.design, solver, signal);
  const offers = await cheaperLays({...asked, garments: [garment, ...added], plan}, means, {
    signal,
  });
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
