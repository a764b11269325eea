/** Pins of a design, moved to places that the symmetries of its garment permit. */
import {askedSymmetries, printOf, type Decisions, type Design} from '../model/design/design.js';
import {grainRule} from '../model/design/grain-rule.js';
import {keptPins, type Mirroring, type PieceFacts} from '../model/design/pins.js';
import type {MeshedPattern} from '../model/result/result.js';
import type {MeasuredSymmetry, Symmetry} from '../model/garment/symmetries.js';
import {pick} from '../scene/marks.js';

const namesOf = (symmetry: Symmetry): readonly [string, string] =>
  symmetry.kind === 'piece' ? [symmetry.piece, symmetry.piece] : symmetry.pieces;

const isOf =
  (symmetry: Symmetry) =>
  ({pieces}: Mirroring): boolean =>
    namesOf(symmetry).every((name) => pieces.includes(name)) &&
    (symmetry.kind === 'piece') === (pieces[0] === pieces[1]);

/** The mirrorings that a design requests. */
export const askedOf = (
  design: Pick<Decisions, 'symmetry'>,
  mirrorings: readonly Mirroring[],
): readonly Mirroring[] =>
  mirrorings.filter((one) => askedSymmetries(design).some((symmetry) => isOf(symmetry)(one)));

/** Facts about a piece. Without a mesh, prints are turned about the piece's origin. */
function factsIn(
  design: Design,
  pattern: Pick<MeshedPattern, 'pieces'> | undefined,
  name: string,
): PieceFacts {
  const {rest = [], outline = []} = pattern?.pieces.find((piece) => piece.name === name) ?? {};
  const loop = pick(rest, outline);
  const middle = (axis: 0 | 1): number =>
    loop.length === 0 ? 0 : loop.reduce((sum, point) => sum + point[axis], 0) / loop.length;
  return {middle: [middle(0), middle(1)], rule: grainRule(design, name)};
}

/** Moves pins; returns the same object when no pin has to move. */
export function withKeptPins(
  design: Design,
  pattern: Pick<MeshedPattern, 'pieces'> | undefined,
  mirrorings: readonly Mirroring[],
): Design {
  const {pins} = design.options;
  if (!pins) return design;
  const kept = keptPins(printOf(design.print), mirrorings, pins, (name) =>
    factsIn(design, pattern, name),
  );
  return kept === pins ? design : {...design, options: {...design.options, pins: kept}};
}

/** Mirrorings of pinned pieces, as far as their symmetries can be measured. */
export async function measuredMirrorings(
  design: Design,
  measure: (symmetry: Symmetry) => Promise<MeasuredSymmetry>,
): Promise<readonly Mirroring[]> {
  const {pins = {}} = design.options;
  const concerned = askedSymmetries(design).filter((one) =>
    namesOf(one).some((name) => name in pins),
  );
  const all = await Promise.allSettled(concerned.map(measure));
  return all.flatMap((one, k) => {
    const symmetry = concerned[k];
    return one.status === 'fulfilled' && symmetry
      ? [{pieces: namesOf(symmetry), map: one.value.map}]
      : [];
  });
}
