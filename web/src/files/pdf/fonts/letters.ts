/** Letters of the embedded font, and widths of text. */
import {sansRanges, sansWidths} from './sans-widths.js';

export type Weight = keyof typeof sansWidths;

/** Glyphs of the embedded font by code point. */
const glyphs = new Map(
  sansRanges
    .split(' ')
    .flatMap((range) => {
      const [first = 0, last = first] = range.split('-').map(Number);
      return Array.from({length: last - first + 1}, (_, k) => first + k);
    })
    .map((code, k) => [code, k + 1]),
);

const numbersIn = (list: string): readonly number[] => list.split(' ').map(Number);
const widths = {regular: numbersIn(sansWidths.regular), bold: numbersIn(sansWidths.bold)};

/** The glyph of a code point in the embedded font; 0 if the font does not have it. */
export const sansGlyph = (code: number): number => glyphs.get(code) ?? 0;

export const codeOf = (letter: string): number => letter.codePointAt(0) ?? 0;

/** Widths of other letters relative to the font size; East Asian letters fill a square. */
const otherWidths = {square: 1, mark: 0, usual: 0.6};

function otherWidth(letter: string): number {
  if (/\p{Mark}/u.test(letter)) return otherWidths.mark;
  const isSquare =
    /[\u1100-\u115f\u2e80-\ua4cf\uac00-\ud7a3\uf900-\ufaff\ufe30-\ufe6f\uff00-\uff60\uffe0-\uffe6]/.test(
      letter,
    ) || codeOf(letter) >= 0x1f000;
  return isSquare ? otherWidths.square : otherWidths.usual;
}

/** Text without line ends and with composed accents. */
export const plainLetters = (text: string): readonly string[] =>
  Array.from(text.normalize('NFC').replaceAll(/\s/g, ' '));

/** The width of a text relative to the font size. */
export const widthOf = (text: string, weight: Weight = 'regular'): number =>
  plainLetters(text).reduce((sum, letter) => {
    const glyph = sansGlyph(codeOf(letter));
    return sum + (glyph > 0 ? (widths[weight][glyph - 1] ?? 0) / 1000 : otherWidth(letter));
  }, 0);

/** Consecutive letters that the embedded font has, or has not. */
interface LetterRun {
  readonly text: string;
  readonly isSans: boolean;
}

export function runsOf(text: string): readonly LetterRun[] {
  const runs: {text: string; readonly isSans: boolean}[] = [];
  for (const letter of plainLetters(text)) {
    const isSans = sansGlyph(codeOf(letter)) > 0;
    const last = runs.at(-1);
    // a space between words of another script is a part of them
    if (last && (last.isSans === isSans || (letter === ' ' && !last.isSans))) last.text += letter;
    else runs.push({text: letter, isSans});
  }
  return runs;
}
