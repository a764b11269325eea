/** An answer laid on cloth, as a plan. */
import {layPlan} from '../../marker/plan.js';
import {markerOrder, type LaidPrint} from '../../marker/problem.js';
import type {Design} from '../../model/design.js';
import type {LayPlan} from '../../model/lay-plan.js';
import type {SolveResult} from '../../model/result.js';
import type {Workbench} from '../../workbench/workbench.js';

/** All that a layout depends on. */
export interface LaidAnswer extends Pick<Design, 'garment' | 'options' | 'names'> {
  readonly result: SolveResult;
  readonly print: LaidPrint;
  /** Of the cloth between its edges, and what is of no use along each of them. */
  readonly widthCm: number;
  readonly selvedgeCm: number;
}

/** @throws {SolverError} for cloth on which it cannot lie, naming the piece; the signal's reason */
export async function layOnCloth(
  workbench: Workbench,
  {result, garment, options, names, print, widthCm, selvedgeCm}: LaidAnswer,
  signal: AbortSignal,
): Promise<LayPlan> {
  const document = await workbench.documentOf(garment);
  signal.throwIfAborted();
  const order = markerOrder(
    [{result, garment: document, options, ...(names && {names})}],
    {widthCm, selvedgeCm},
    print,
  );
  return layPlan(order, await workbench.solver.marker(order.problem, {signal}));
}
