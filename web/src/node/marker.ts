/** Pieces of results laid on cloth, as a plan. */
import {cheaperLays} from '../marker/cheaper.js';
import {foldedOrder} from '../marker/fold.js';
import type {MarkerGarment} from '../marker/pieces.js';
import {layPlan} from '../marker/plan.js';
import {markerOrder, type LaidPrint} from '../marker/problem.js';
import type {MarkerSettings} from '../marker/settings.js';
import {failureOf, SolverError} from '../model/failure.js';
import type {LayPlan} from '../model/lay-plan.js';
import type {MarkerAnswer, MarkerHooks, MarkerProblem} from '../model/marker.js';
import type {SolveResult} from '../model/result.js';

export interface NodeMarkerSettings extends MarkerSettings {
  /** The print that the results were solved with, for what they do not repeat of it: whether it has an upside. */
  readonly print?: LaidPrint;
}

/** How to follow the search for a layout and how to end it early. */
export interface MarkerPlanHooks extends Pick<MarkerHooks, 'signal' | 'onProgress'> {
  /** Each plan that is better than those before. */
  readonly onLayout?: (plan: LayPlan) => void;
}

/** Seeks the layout of a problem. */
type Lay = (problem: MarkerProblem, hooks: MarkerHooks) => Promise<MarkerAnswer>;

/** @throws as `marker` does */
export async function markerWith(
  lay: Lay,
  results: readonly (SolveResult | MarkerGarment)[],
  {print, ...settings}: NodeMarkerSettings,
  {onLayout, ...hooks}: MarkerPlanHooks,
): Promise<LayPlan> {
  hooks.signal?.throwIfAborted();
  const garments = results.map((one) => ('result' in one ? one : {result: one}));
  const whole = markerOrder(garments, settings, print);
  const solved = garments.map(({result}) => result);
  const folded = settings.fold ? foldedOrder(whole, solved, settings.phaseCm) : undefined;
  const order = folded?.order ?? whole;
  const planOf = (layout: Parameters<typeof layPlan>[1]): LayPlan => {
    const plan = layPlan(order, layout);
    return folded?.spread(plan) ?? plan;
  };
  const explained = (error: unknown): never => {
    if (!folded || !(error instanceof SolverError) || error.code !== 'options') throw error;
    throw new SolverError({
      ...failureOf(error),
      message: `On half of folded cloth: ${error.message}`,
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
  const plan = planOf(answer);
  const {signal} = hooks;
  const laid = {garments, settings, print, plan};
  return {...plan, cheaper: await cheaperLays(laid, lay, {...(signal && {signal})})};
}
