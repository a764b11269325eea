/** What seams and mirrored pairs are called in short: the same on the page, in pictures and on the pieces to cut. */

/** Of a seam, by its number: A, B, ... Z, AA, AB, ... What has the same letter is sewn together. */
export const seamLetter = (number: number): string =>
  (number >= 26 ? seamLetter(Math.floor(number / 26) - 1) : '') +
  String.fromCharCode(65 + (number % 26));

/** Letters of no seam, so that nobody sews together what only mirrors. */
const pairLetters = 'αβγδεζηθικλμνξοπρστυφχψω';

/** Of a mirrored pair, the same whatever other pairs there are just now: no two of them share a piece. */
export function pairLetter(pieces: readonly [number, number]): string {
  const first = Math.min(...pieces);
  const round = Math.floor(first / pairLetters.length);
  return `${pairLetters[first % pairLetters.length] ?? ''}${round || ''}`;
}
