/** Sewn and cut lines of a garment's pieces, from its file and an allowance rule. Lengths in cm. */
import {drained} from '../model/base/drained.js';
import type {PanelMarks} from '../model/garment/panel-marks.js';
import type {Point} from '../model/geometry/vectors.js';
import {readable} from '../model/garment/piece-names.js';
import type {SolveResult} from '../model/result/result.js';
import {allowancesOf, type AllowanceRule, type Allowances} from './allowances.js';
import {cutLine} from './cut-line.js';
import {allowedLoops, garmentEdges, type GarmentEdges} from './garment-edges.js';

interface CutLines {
  /** Indexed by piece, like all following fields. */
  readonly marks: readonly PanelMarks[];
  readonly garment: GarmentEdges;
  readonly allowances: Allowances;
  readonly loops: readonly ReturnType<typeof allowedLoops>[];
  /** In coordinates of the shape: the outline counter-clockwise, then the holes clockwise. */
  readonly cut: readonly (readonly (readonly Point[])[])[];
}

/**
 * Computes the lines in steps of about ten milliseconds.
 * @param panels marks from the garment file, by piece name
 */
export function* cutLineSteps(
  result: Pick<SolveResult, 'pieces' | 'seams'>,
  panels: ReadonlyMap<string, PanelMarks>,
  rule: AllowanceRule,
): Generator<undefined, CutLines> {
  const marks = result.pieces.map(({name}) => panels.get(name) ?? {label: readable(name)});
  const garment = garmentEdges(result, (name) => panels.get(name)?.drafted);
  yield;
  const allowances = allowancesOf(garment, result.pieces, marks, rule);
  yield;
  const loops = result.pieces.map((_, k) => allowedLoops(garment, k));
  const cut: (readonly (readonly Point[])[])[] = [];
  for (const all of loops) {
    yield;
    cut.push(cutLine(all, allowances));
  }
  return {marks, garment, allowances, loops, cut};
}

/** Computes the lines in one call. */
export const cutLinesOf = (...asked: Parameters<typeof cutLineSteps>): CutLines =>
  drained(cutLineSteps(...asked));
