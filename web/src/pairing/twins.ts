/**
 * Separates the seam that closes a piece with a twin, such as a sleeve, from a seam between the
 * twins.
 */
import type {MeasuredGarment, MeasuredPiece} from './edges.js';

/** Returns whether both are sleeves or cuffs of the same face whose names allow opposite sides. */
const areSleeves = ({words: one}: MeasuredPiece, {words: other}: MeasuredPiece): boolean =>
  one.kind === other.kind &&
  (one.isSleeve || one.kind === 'cuff') &&
  one.face === other.face &&
  one.side === (-other.side as typeof one.side);

/** Returns the length of a piece's outline. [cm] */
const outlineLength = ({edges}: MeasuredGarment, {first, count}: MeasuredPiece): number =>
  edges.slice(first, first + count).reduce((sum, {length}) => sum + length, 0);

/**
 * Returns whether two symmetric pieces have the same shape, judged by area and outline: an edge may
 * be split in one of them, as the cap of a sleeve that is set in.
 */
const areEqual = (garment: MeasuredGarment, one: MeasuredPiece, other: MeasuredPiece): boolean =>
  Math.abs(Math.log(one.area / other.area)) < 0.01 &&
  Math.abs(Math.log(outlineLength(garment, one) / outlineLength(garment, other))) < 0.01;

/**
 * Returns whether a seam would join a piece to its twin although each is closed on its own. Two
 * edges that mirror each other may meet, as at a centre, but never those of two sleeves.
 * @param images mirror image of each edge, or -1
 */
export function isOfTwins(
  garment: MeasuredGarment,
  images: Int32Array,
  i: number,
  j: number,
): boolean {
  const {edges, pieces} = garment;
  const [a, b] = [edges[i], edges[j]];
  const [p, q] = [pieces[a?.at.piece ?? -1], pieces[b?.at.piece ?? -1]];
  if (!a || !b || !p || !q || p === q) return false;
  const [imageA = -1, imageB = -1] = [images[i], images[j]];
  const [atA, atB] = [edges[imageA]?.at.piece, edges[imageB]?.at.piece];
  if (atA === b.at.piece && atB === a.at.piece) return imageA !== j || areSleeves(p, q);
  return atA === a.at.piece && atB === b.at.piece && areSleeves(p, q) && areEqual(garment, p, q);
}

/** Greatest difference of log lengths: underarms are eased by less. */
const ease = 0.07;

/**
 * Returns whether two edges close a one-piece sleeve: one runs up it and the other down, on
 * opposite sides.
 */
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
