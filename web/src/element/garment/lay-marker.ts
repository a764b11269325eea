/** Fabric layout of an answer. */
import {layPlan} from '../../marker/plan.js';
import {markerOrder, type LaidPrint} from '../../marker/problem.js';
import type {Design} from '../../model/design/design.js';
import type {LayPlan} from '../../model/result/marker-plan.js';
import type {SolveResult} from '../../model/result/result.js';
import type {Workbench} from '../../workbench/workbench.js';

/** All inputs of a layout. */
export interface LaidAnswer extends Pick<Design, 'garment' | 'options' | 'names'> {
  readonly result: SolveResult;
  readonly print: LaidPrint;
  /** Fabric width between its edges, and the unusable strip along each of them. [cm] */
  readonly widthCm: number;
  readonly selvedgeCm: number;
}

/**
 * @throws {SolverError} if a piece does not fit on the fabric, with the piece's name; the signal's
 * reason
 */
export async function layMarker(
  workbench: Workbench,
  {result, garment, options, names, print, widthCm, selvedgeCm}: LaidAnswer,
  signal: AbortSignal,
): Promise<LayPlan> {
  const document = await workbench.solving.documentOf(garment);
  signal.throwIfAborted();
  const order = markerOrder(
    [{result, garment: document, options, ...(names && {names})}],
    {widthCm, selvedgeCm},
    print,
  );
  return layPlan(order, await workbench.solver.marker(order.problem, {signal}));
}
