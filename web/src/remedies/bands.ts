/**
 * Selects the pieces to rotate where grains cross at seams: bands, rather than the pieces they are
 * sewn to.
 */
import {distance} from '../model/geometry/vectors.js';
import {boxOf, lengthOf, signedArea} from '../model/geometry/polyline.js';
import type {Pattern, ResultSeam} from '../model/result/result.js';
import {pick} from '../scene/marks.js';

const seamLength = ({pieces}: Pattern, {a: {piece, vertices}}: ResultSeam): number =>
  lengthOf(pick(pieces[piece]?.rest ?? [], vertices));

/**
 * The width of a drafted piece across its length: its area divided by the diagonal of its bounding
 * box. [cm]
 */
function breadthOf({pieces}: Pattern, piece: number): number {
  const {rest = [], outline = []} = pieces[piece] ?? {};
  const loop = pick(rest, outline);
  const {low, high} = boxOf(loop);
  return Math.abs(signedArea(loop)) / distance(low, high);
}

/**
 * Sets of pieces to rotate together, each with its crossed seams. At every crossed seam, the
 * narrower side is rotated; of two equal ones, the one with less other seam length. Its mirror
 * image and pieces of its kind that are joined to it without crossed grains are included: a band in
 * two halves would otherwise no longer match at its joint.
 * @param crossed indices of the seams with crossed grains
 * @param canTurn returns whether a piece's grain can be rotated
 */
export function bandsOf(
  pattern: Pattern,
  crossed: readonly number[],
  canTurn: (piece: number) => boolean,
): readonly {readonly pieces: readonly number[]; readonly seams: readonly number[]}[] {
  const {seams, symmetries} = pattern;
  const at = crossed.flatMap((number) => {
    const seam = seams[number];
    return seam && seam.a.piece !== seam.b.piece ? [{number, seam}] : [];
  });
  const other = new Map<number, number>();
  seams.forEach((seam, number) => {
    if (crossed.includes(number)) return;
    for (const {piece} of [seam.a, seam.b]) {
      other.set(piece, (other.get(piece) ?? 0) + seamLength(pattern, seam));
    }
  });
  const breadth = (piece: number): number => breadthOf(pattern, piece);
  const bands = new Set(
    at.flatMap(({seam: {a, b}}) => {
      const sides = [a.piece, b.piece].filter(canTurn);
      return sides
        .toSorted((p, q) => breadth(p) - breadth(q) || (other.get(p) ?? 0) - (other.get(q) ?? 0))
        .slice(0, 1);
    }),
  );
  const twins = symmetries.flatMap((one) => (one.kind === 'pair' ? [one.pieces] : []));
  for (const [first, second] of twins) {
    if (bands.has(first) || bands.has(second)) bands.add(first).add(second);
  }
  const uncrossed = seams.filter((_, number) => !crossed.includes(number));
  const joins = [...twins, ...uncrossed.map(({a, b}) => [a.piece, b.piece] as const)];
  return connected([...bands], joins).map((pieces) => ({
    pieces,
    seams: at
      .filter(({seam: {a, b}}) => pieces.includes(a.piece) !== pieces.includes(b.piece))
      .map(({number}) => number),
  }));
}

/** The connected sets of pieces under the given joins. */
function connected(
  pieces: readonly number[],
  joins: readonly (readonly [number, number])[],
): readonly (readonly number[])[] {
  const sets: number[][] = pieces.map((piece) => [piece]);
  for (const [first, second] of joins) {
    const one = sets.find((set) => set.includes(first));
    const other = sets.find((set) => set.includes(second));
    if (!one || !other || one === other) continue;
    one.push(...other);
    sets.splice(sets.indexOf(other), 1);
  }
  return sets;
}
