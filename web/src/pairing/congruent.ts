/** Finds pieces of the same shape, which can be exchanged for each other as long as none is sewn. */
import type {MeasuredEdge, MeasuredGarment, MeasuredPiece} from './edges.js';

/** Greatest difference of equal edges, as a share of a length or as an angle. [rad] */
const most = 0.02;

const areEqual = (a: MeasuredEdge, b: MeasuredEdge): boolean =>
  Math.abs(Math.log(a.length / b.length)) < most &&
  Math.abs(a.corner - b.corner) < 2 * most &&
  a.profile.every((heading, k) => Math.abs(heading - (b.profile[k] ?? 0)) < 2 * most);

/** Greatest turn of a chord relative to the grain between pieces that are drawn alike. */
const alike = 0.05;

/** Returns the edges of a piece that equal those of another; undefined if the shapes differ. */
function copyOf(
  {edges}: MeasuredGarment,
  a: MeasuredPiece,
  b: MeasuredPiece,
): readonly number[] | undefined {
  if (a.count !== b.count || Math.abs(Math.log(a.area / b.area)) > most) return undefined;
  for (let shift = 0; shift < a.count; shift++) {
    const copies = Array.from({length: a.count}, (_, k) => b.first + ((k + shift) % b.count));
    const isCopy = copies.every((copy, k) => {
      const [one, other] = [edges[a.first + k], edges[copy]];
      if (!one || !other || !areEqual(one, other)) return false;
      return Math.hypot(one.chord[0] - other.chord[0], one.chord[1] - other.chord[1]) < alike;
    });
    if (isCopy) return copies;
  }
  return undefined;
}

/**
 * Returns the edges that take the place of each edge if its piece is exchanged for one of the same
 * shape, with the edge itself first.
 */
export function copiesOf(garment: MeasuredGarment): readonly (readonly number[])[] {
  const copies = garment.edges.map((_, edge) => [edge]);
  const {pieces} = garment;
  for (const [k, piece] of pieces.entries()) {
    for (const other of pieces.slice(k + 1)) {
      copyOf(garment, piece, other)?.forEach((copy, edge) => {
        copies[piece.first + edge]?.push(copy);
        copies[copy]?.push(piece.first + edge);
      });
    }
  }
  return copies;
}
