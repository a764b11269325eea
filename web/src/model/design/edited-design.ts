/**
 * A design after an edit of its garment. Decisions by numbers of edges and seams follow the new
 * numbers.
 */
import type {Design} from './design.js';
import type {GarmentDocument} from '../garment/garment-document.js';
import {garmentFile} from '../garment/write-garment.js';
import {axisBetween, type Edited} from '../garment/edits.js';
import type {Locks, SolveOptions} from './options.js';
import type {Symmetry} from '../garment/symmetries.js';

/** Maps an edge of a piece to its new numbers. */
type Renumbered = (piece: string, edge: number) => readonly number[];

const lockedAfter = (locked: Locks, edges: Renumbered): Locks =>
  Object.fromEntries(
    Object.entries(locked).map(([name, lock]) => [
      name,
      lock === true ? lock : lock.flatMap((edge) => edges(name, edge)),
    ]),
  );

const weightsAfter = (
  weights: Readonly<Record<string, number>>,
  {seamsOf}: Edited,
): Readonly<Record<string, number>> =>
  Object.fromEntries(
    Object.entries(weights).flatMap(([seam, weight]) =>
      seamsOf(Number(seam)).map((number) => [number, weight]),
    ),
  );

function optionsAfter(options: SolveOptions, edited: Edited, edges: Renumbered): SolveOptions {
  const {locked, weights, unmatched} = options;
  return {
    ...options,
    ...(locked && {locked: lockedAfter(locked, edges)}),
    ...(weights && {weights: weightsAfter(weights, edited)}),
    ...(unmatched && {unmatched: unmatched.flatMap(edited.seamsOf)}),
  };
}

/**
 * Keeps a symmetry by edges if both are whole; otherwise uses the axis between them, in the
 * coordinates of the file.
 */
function symmetryAfter(one: Symmetry, {pieces}: GarmentDocument, edges: Renumbered): Symmetry {
  if (one.kind !== 'piece' || !one.seams) return one;
  const [first, second] = one.seams.map((edge) => edges(one.piece, edge));
  const [a, b] = [first?.[0], second?.[0]];
  if (a === undefined || b === undefined) return one;
  if (first?.length === 1 && second?.length === 1) return {...one, seams: [a, b]};
  const {outline = [], mirroredFromInput} = pieces.find(({name}) => name === one.piece) ?? {};
  const [from, to] = one.seams.map((edge) => outline[edge]);
  if (!from || !to) return one;
  const [p, q] = axisBetween(from, to);
  const x = mirroredFromInput ? -1 : 1;
  return {
    kind: 'piece',
    piece: one.piece,
    axis: [
      [x * p[0], p[1]],
      [x * q[0], q[1]],
    ],
  };
}

/**
 * The parts of a design that change with an edit of its garment. The edited garment no longer
 * refers to a sample or a source file.
 * @param before content of the file before the edit
 */
export function designAfter(
  {garment, options, symmetry}: Pick<Design, 'garment' | 'options' | 'symmetry'>,
  before: GarmentDocument,
  edited: Edited,
): Pick<Design, 'garment' | 'options' | 'symmetry'> {
  const edges: Renumbered = (name, edge) => {
    const piece = before.pieces.findIndex((one) => one.name === name);
    return edited.edgesOf({piece, edge}).map((part) => part.edge);
  };
  return {
    garment: {name: garment.name, text: garmentFile(edited.document)},
    options: optionsAfter(options, edited, edges),
    symmetry:
      typeof symmetry === 'string'
        ? symmetry
        : symmetry.map((one) => symmetryAfter(one, before, edges)),
  };
}
