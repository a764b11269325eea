/** Pieces of results laid on cloth, as a plan. */
import type {MarkerGarment} from '../marker/pieces.js';
import {layPlan} from '../marker/plan.js';
import {markerOrder} from '../marker/problem.js';
import type {MarkerSettings} from '../marker/settings.js';
import type {LayPlan} from '../model/lay-plan.js';
import type {MarkerAnswer, MarkerHooks, MarkerProblem} from '../model/marker.js';
import type {Print} from '../model/print.js';
import type {SolveResult} from '../model/result.js';

export interface NodeMarkerSettings extends MarkerSettings {
  /** The print that the results were solved with, for what they do not repeat of it: whether it has an upside. */
  readonly print?: Pick<Print, 'oneWay'>;
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
  const order = markerOrder(garments, settings, print);
  const answer = await lay(order.problem, {
    ...hooks,
    ...(onLayout && {
      onLayout: (layout) => {
        onLayout(layPlan(order, layout));
      },
    }),
  });
  return layPlan(order, answer);
}
