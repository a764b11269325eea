/** What closes a piece that has a twin, a sleeve say: an edge of its own, not one of the other. */
import type {MeasuredGarment, MeasuredPiece} from './edges.js';

/** Two sleeves of the same face, neither said to be on the side of the other. */
const areSleeves = ({words: one}: MeasuredPiece, {words: other}: MeasuredPiece): boolean =>
  one.isSleeve &&
  other.isSleeve &&
  one.face === other.face &&
  one.side === (-other.side as typeof one.side);

/** Two symmetric pieces of the same shape, as far as their edges tell. */
const areEqual = (one: MeasuredPiece, other: MeasuredPiece): boolean =>
  one.count === other.count && Math.abs(Math.log(one.area / other.area)) < 0.01;

/**
 * Whether a seam between two edges would join a piece to its twin where each is closed by itself. Edges that are each
 * other's image may meet, as at a centre; those of two sleeves never do.
 * @param images the mirror image of each edge, or -1
 */
export function isOfTwins(
  {edges, pieces}: MeasuredGarment,
  images: Int32Array,
  i: number,
  j: number,
): boolean {
  const [a, b] = [edges[i], edges[j]];
  const [p, q] = [pieces[a?.at.piece ?? -1], pieces[b?.at.piece ?? -1]];
  if (!a || !b || !p || !q || p === q) return false;
  const [imageA = -1, imageB = -1] = [images[i], images[j]];
  const [atA, atB] = [edges[imageA]?.at.piece, edges[imageB]?.at.piece];
  if (atA === b.at.piece && atB === a.at.piece) return imageA !== j || areSleeves(p, q);
  return atA === a.at.piece && atB === b.at.piece && areSleeves(p, q) && areEqual(p, q);
}

/** Of lengths: underarms are eased by less. */
const ease = 0.07;

/** Whether a sleeve that is one piece would be closed by two edges: they run up and down it, and nothing else does. */
export function isUnderarm({edges, pieces}: MeasuredGarment, i: number, j: number): boolean {
  const [a, b] = [edges[i], edges[j]];
  if (!a || !b) return false;
  const {words} = pieces[a.at.piece] ?? {};
  return (
    a.at.piece === b.at.piece &&
    words?.isSleeve === true &&
    words.face === 0 &&
    a.chord[1] * b.chord[1] < -0.25 &&
    a.place[0] * b.place[0] < 0 &&
    a.after !== j &&
    b.after !== i &&
    Math.abs(Math.log(a.length / b.length)) < ease
  );
}
