/** Where the pieces of a garment are sewn and cut, as far as its file and a rule say it. Lengths in cm. */
import type {PanelMarks} from '../model/garment-marks.js';
import type {Point} from '../model/geometry.js';
import {readable} from '../model/piece-names.js';
import type {SolveResult} from '../model/result.js';
import {allowancesOf, type AllowanceRule, type Allowances} from './allowances.js';
import {cutLine} from './cut-line.js';
import {allowedLoops, garmentEdges, type GarmentEdges} from './garment-edges.js';

interface CutLines {
  /** By piece, as all that follows. */
  readonly marks: readonly PanelMarks[];
  readonly garment: GarmentEdges;
  readonly allowances: Allowances;
  readonly loops: readonly ReturnType<typeof allowedLoops>[];
  /** In the coordinates of the shape: the outline counter-clockwise, then holes clockwise. */
  readonly cut: readonly (readonly (readonly Point[])[])[];
}

/** @param panels what the garment's file says of its pieces, by name */
export function cutLinesOf(
  result: Pick<SolveResult, 'pieces' | 'seams'>,
  panels: ReadonlyMap<string, PanelMarks>,
  rule: AllowanceRule,
): CutLines {
  const marks = result.pieces.map(({name}) => panels.get(name) ?? {label: readable(name)});
  const garment = garmentEdges(result, (name) => panels.get(name)?.drafted);
  const allowances = allowancesOf(garment, result.pieces, marks, rule);
  const loops = result.pieces.map((_, k) => allowedLoops(garment, k));
  return {
    ...{marks, garment, allowances, loops},
    cut: loops.map((all) => cutLine(all, allowances)),
  };
}
