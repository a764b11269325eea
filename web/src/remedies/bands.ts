/** Which pieces to turn where grains run across each other: the bands, not what they are sewn to. */
import {distance} from '../model/geometry.js';
import {boxOf, lengthOf, signedArea} from '../model/polyline.js';
import type {Pattern, ResultSeam} from '../model/result.js';
import {pick} from '../scene/marks.js';

const seamLength = ({pieces}: Pattern, {a: {piece, vertices}}: ResultSeam): number =>
  lengthOf(pick(pieces[piece]?.rest ?? [], vertices));

/** How broad a piece is across its length, as drafted: its area by the diagonal of the box around it. [cm] */
function breadthOf({pieces}: Pattern, piece: number): number {
  const {rest = [], outline = []} = pieces[piece] ?? {};
  const loop = pick(rest, outline);
  const {low, high} = boxOf(loop);
  return Math.abs(signedArea(loop)) / distance(low, high);
}

/**
 * Sets of pieces to be turned together, each with the seams that it is about. Of every seam the narrower side is turned,
 * of two alike the one with less other seam to it, and with it its mirror image and what it is sewn to of its own kind
 * with grains that do not cross: turned alone, a band in two halves would no longer meet where they join.
 * @param crossed numbers of the seams at which the grains cross
 * @param canTurn whether a piece lies on a grain that can be turned
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

/** The sets into which pieces fall that are joined, directly or by others of them. */
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
