/**
 * Short names of seams and mirrored pairs, the same on the page, in images and on the cutting
 * sheet.
 */

/** Numbers from 0 as letters: A, B, ... Z, AA, AB, ... */
export const letters = (number: number): string =>
  (number >= 26 ? letters(Math.floor(number / 26) - 1) : '') +
  String.fromCharCode(65 + (number % 26));

/** Letter of a seam by its number. Edges with the same letter are sewn together. */
export const seamLetter = letters;

/** Letters that no seam has, so that a mirrored pair is not mistaken for a seam. */
const pairLetters = 'αβγδεζηθικλμνξοπρστυφχψω';

/**
 * Letter of a mirrored pair. It does not depend on the other pairs, because no two pairs share a
 * piece.
 */
export function pairLetter(pieces: readonly [number, number]): string {
  const first = Math.min(...pieces);
  const round = Math.floor(first / pairLetters.length);
  return `${pairLetters[first % pairLetters.length] ?? ''}${round || ''}`;
}
