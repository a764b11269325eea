/** Writes a layout for plotters and cutters in HP-GL, lengthwise along the paper. */
import {strokesOf} from '../../cutting/out/sheet-hpgl.js';
import {hpglText} from '../../files/hpgl/hpgl.js';
import type {LayPlan} from '../../model/result/marker-plan.js';
import {planPieces, type KnownPieces} from './plan-pieces.js';

/**
 * HP-GL text.
 * @throws {SolverError} `options` if the fabric is too wide for a plotter
 */
export function planHpgl(plan: LayPlan, known: KnownPieces = {}): string {
  const pieces = planPieces(plan, known, ({piece}) => piece);
  return hpglText(strokesOf(pieces.map(({cut, laid}) => laid ?? {cut: [cut], marks: []})));
}
