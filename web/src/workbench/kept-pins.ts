/** Pins of a design, moved to places that the symmetries of its garment permit. */
import {askedSymmetries, printOf, type Decisions, type Design} from '../model/design/design.js';
import {grainRule} from '../model/design/grain-rule.js';
import {keptPins, type Mirroring, type PieceFacts} from '../model/design/pins.js';
import type {MeshedPattern} from '../model/result/result.js';
import type {MeasuredSymmetry, Symmetry} from '../model/garment/symmetries.js';
import {pick} from '../scene/marks.js';
import {keptParts} from '../model/design/locks.js';
import type {Locks} from '../model/design/options.js';
import type {KeptLine} from '../scene/scene.js';

// Locked parts of outlines, as lines to draw.

/**
 * Locked edges of an outline, by their number in it, as runs of neighbours that are all sewn or all
 * not sewn.
 */
function runs(
  outline: readonly number[],
  isKept: (edge: number) => boolean,
  isSewn: (edge: number) => boolean,
): readonly Omit<KeptLine, 'piece'>[] {
  const n = outline.length;
  const continues = (k: number): boolean =>
    isKept(k) && isKept((k + n - 1) % n) && isSewn(k) === isSewn((k + n - 1) % n);
  const starts = outline.flatMap((_, k) => (isKept(k) && !continues(k) ? [k] : []));
  // a run around the whole outline has no start
  const all = starts.length === 0 && n > 0 && isKept(0) ? [0] : starts;
  return all.map((start) => {
    let count = 1;
    while (count < n && continues((start + count) % n)) count++;
    const vertices = Array.from({length: count + 1}, (_, k) => outline[(start + k) % n] ?? 0);
    return {vertices, isSewn: isSewn(start)};
  });
}

/** Lines of the locked edges; undefined when nothing is locked. */
export function keptLines(
  pattern: MeshedPattern,
  locked: Locks | undefined,
): readonly KeptLine[] | undefined {
  if (!locked || Object.keys(locked).length === 0) return undefined;
  const parts = keptParts(pattern, locked);
  return pattern.pieces.flatMap(({outline, edges}, piece) => {
    const {edges: keptEdges = new Set()} = parts[piece] ?? {};
    if (keptEdges.size === 0) return [];
    const sewn = new Set(
      pattern.seams
        .flatMap(({a, b}) => [a, b])
        .filter((side) => side.piece === piece)
        .flatMap(({vertices}) =>
          vertices.slice(1).flatMap((v, k) => [`${vertices[k]} ${v}`, `${v} ${vertices[k]}`]),
        ),
    );
    return runs(
      outline,
      (k) => keptEdges.has(edges[k] ?? -1),
      (k) => sewn.has(`${outline[k]} ${outline[(k + 1) % outline.length]}`),
    ).map((run) => ({...run, piece}));
  });
}

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
