/**
 * White veils over the print of a layout, which make pieces and text legible. Lengths in cm on the
 * fabric.
 */
import type {Point} from '../../model/geometry/vectors.js';
import type {LayPlan} from '../../model/result/marker-plan.js';
import {boxAt, cornersOf} from '../../paper/boxes.js';

/** Closed lines, filled by the even-odd rule. */
interface Veil {
  readonly loops: readonly (readonly Point[])[];
  readonly opacity: number;
}

interface Veils {
  /** The outline of the fabric. */
  readonly around: readonly Point[];
  readonly outside: Veil;
  readonly inside: Veil;
}

/** @param holes cut-outs of the pieces */
export function veils(
  {widthCm, placements}: LayPlan,
  {from, to}: {readonly from: number; readonly to: number},
  holes: readonly (readonly Point[])[] = [],
): Veils {
  const around = cornersOf(boxAt([0, from], widthCm, to - from));
  const pieces = [...placements.map(({cut}) => cut), ...holes];
  return {
    around,
    outside: {loops: [around, ...pieces], opacity: 0.72},
    inside: {loops: pieces, opacity: 0.3},
  };
}
