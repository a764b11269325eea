/** Computes the layout of results on fabric. */
import type {MarkerGarment} from '../model/design/marker-garment.js';
import {cheaperLays, withOffers} from '../marker/cheaper.js';
import type {SolveDesign} from '../marker/designs.js';
import {foldedOrder} from '../marker/fold.js';
import {garmentShares} from '../marker/garment-shares.js';
import {layPlan} from '../marker/plan.js';
import {markerOrder, type LaidPrint} from '../marker/problem.js';
import type {MarkerSettings} from '../marker/settings.js';
import {layShifted, type Lay} from '../marker/shifted.js';
import {failureOf, SolverError} from '../model/base/failure.js';
import type {LayPlan} from '../model/result/marker-plan.js';
import type {MarkerHooks} from '../model/result/marker-search.js';
import type {SolveResult} from '../model/result/result.js';

export interface NodeMarkerSettings extends MarkerSettings {
  /** The print of the results, for properties that they do not repeat: whether it is one-way. */
  readonly print?: LaidPrint;
}

/** Hooks for the progress of a layout, and for aborting it. */
export interface MarkerPlanHooks extends Pick<MarkerHooks, 'signal' | 'onProgress'> {
  /** Called with each layout that improves on the previous ones. */
  readonly onLayout?: (plan: LayPlan) => void;
}

/**
 * Computes a layout with its fold and shifts, without looking for cheaper ones.
 * @throws {SolverError} under the conditions of `marker`
 */
export async function layWith(
  lay: Lay,
  garments: readonly MarkerGarment[],
  {print, ...settings}: NodeMarkerSettings,
  {onLayout, ...hooks}: MarkerPlanHooks,
): Promise<LayPlan> {
  const whole = markerOrder(garments, settings, print);
  const solved = garments.map(({result}) => result);
  const folded = settings.fold ? foldedOrder(whole, solved, settings.phaseCm) : undefined;
  const order = folded?.order ?? whole;
  const planOf = (layout: Parameters<typeof layPlan>[1], of = order): LayPlan => {
    const plan = layPlan(of, layout);
    return folded?.spread(plan) ?? plan;
  };
  const explained = (error: unknown): never => {
    if (!folded || !(error instanceof SolverError) || error.code !== 'options') throw error;
    throw new SolverError({
      ...failureOf(error),
      message: `For one ply of folded fabric, from its edge to the fold: ${error.message}`,
    });
  };
  const answer = await lay(order.problem, {
    ...hooks,
    ...(onLayout && {
      onLayout: (layout) => {
        onLayout(planOf(layout));
      },
    }),
  }).catch(explained);
  const shifted =
    settings.shift === 'component' ? await layShifted(order, answer, lay, hooks) : {order, answer};
  return planOf(shifted.answer, shifted.order);
}

/**
 * Computes a layout, and offers cheaper ones.
 * @throws {SolverError} under the conditions of `marker`
 */
export async function markerWith(
  {lay, solve}: {readonly lay: Lay; readonly solve: SolveDesign},
  results: readonly (SolveResult | MarkerGarment)[],
  settings: NodeMarkerSettings,
  hooks: MarkerPlanHooks,
): Promise<LayPlan> {
  const {signal} = hooks;
  signal?.throwIfAborted();
  const garments = results.map((one) => ('result' in one ? one : {result: one}));
  const plan = await layWith(lay, garments, settings, hooks);
  const {print, ...rest} = settings;
  const laid = {garments, settings: rest, print, plan};
  const cheaper = await cheaperLays(laid, {lay, solve}, {...(signal && {signal})});
  return {...withOffers(plan, cheaper), garments: garmentShares(plan)};
}
