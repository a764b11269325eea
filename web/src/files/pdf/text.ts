/** Text in Helvetica, which every PDF viewer has: letters of Windows-1252 and their widths. */
import {nums, scoped, through} from './content.js';
import {towards, type Point} from '../../model/geometry/vectors.js';

/** Letters of the codes 128 to 159. */
const others = '€\0‚ƒ„…†‡ˆ‰Š‹Œ\0Ž\0\0‘’“”•–—˜™š›œ\0žŸ';

const cyrillic =
  'а a б b в v г g д d е e ж zh з z и i й y к k л l м m н n о o п p р r с s т t у u ф f х kh ц ts ч ch ш sh щ shch ъ _ ы y ь _ э e ю yu я ya і i ї yi є ye ґ g ђ dj ј j љ lj њ nj ћ c џ dz';
const greek =
  'α a β b γ g δ d ε e ζ z η i θ th ι i κ k λ l μ m ν n ξ x ο o π p ρ r σ s ς s τ t υ y φ f χ ch ψ ps ω o';
const latin = 'ł l đ d ħ h ŋ n ŧ t ı i − - ‐ - ‑ - → -> ← <- ⁄ / ′ \' ″ " ≤ <= ≥ >= ≈ ~';

/** Replacements for letters that are missing from the font. */
const written = new Map(
  [cyrillic, greek, latin].flatMap((list) => {
    const words = list.split(' ');
    return words.flatMap((letter, k) =>
      k % 2 === 0 ? [[letter, words[k + 1]?.replace('_', '') ?? ''] as const] : [],
    );
  }),
);

const codeOf = (letter: string): number | undefined => {
  const code = letter.codePointAt(0) ?? 0;
  if ((code >= 32 && code < 127) || (code >= 160 && code < 256)) return code;
  const place = others.indexOf(letter);
  return place >= 0 && code > 0 ? 128 + place : undefined;
};

/** A letter in characters of the font; '?' if there is no readable replacement. */
function inFont(letter: string): string {
  if (codeOf(letter) !== undefined) return letter;
  const lower = letter.toLowerCase();
  const known = written.get(letter) ?? written.get(lower);
  if (known !== undefined) {
    return lower === letter ? known : known.charAt(0).toUpperCase() + known.slice(1);
  }
  const [base = '', ...accents] = letter.normalize('NFD');
  return accents.length > 0 ? inFont(base) : '?';
}

/** The text in characters of the font; unchanged if the font has them all. */
export const inFontLetters = (text: string): string =>
  Array.from(text.normalize('NFC').replaceAll(/\s/g, ' '), inFont).join('');

const units = (list: string): readonly number[] => list.split(' ').map(Number);

/**
 * Widths from space to tilde in thousandths of the font size, from Adobe's metrics of the standard
 * fonts.
 */
const widths = {
  regular: units(
    '278 278 355 556 556 889 667 191 333 333 389 584 278 333 278 278 556 556 556 556 556 556 556 556 556 556 278 278 584 584 584 556 1015 667 667 722 722 667 611 778 722 278 500 667 556 833 722 778 667 778 722 667 611 722 667 944 667 667 611 278 278 278 469 556 333 556 556 500 556 556 278 556 556 222 222 500 222 833 556 556 556 556 333 500 278 556 500 722 500 500 500 334 260 334 584',
  ),
  bold: units(
    '278 333 474 556 556 889 722 238 333 333 389 584 278 333 278 278 556 556 556 556 556 556 556 556 556 556 333 333 584 584 584 611 975 722 722 722 722 667 611 778 722 278 556 722 611 833 722 778 667 778 722 667 611 722 667 944 667 667 611 333 278 333 584 556 333 556 611 556 611 556 333 611 611 278 278 556 278 889 611 611 611 611 389 556 333 611 556 778 556 556 500 389 280 389 584',
  ),
};
const wide: Readonly<Record<string, number>> = {'×': 584, '°': 400, '—': 1000, '…': 1000};
const usual = 556;

export type Weight = keyof typeof widths;

/** Font names in the resources of pages. */
export const fontNames: Readonly<Record<Weight, string>> = {regular: 'F1', bold: 'F2'};

/** The width of a text relative to the font size. Accents do not change the width of a letter. */
export function widthOf(text: string, weight: Weight = 'regular'): number {
  let sum = 0;
  for (const letter of inFontLetters(text)) {
    const plain = letter.normalize('NFD').charCodeAt(0);
    sum += wide[letter] ?? widths[weight][plain - 32] ?? usual;
  }
  return sum / 1000;
}

/** The text as a string of a content stream. */
function shown(text: string): string {
  const letters = Array.from(inFontLetters(text), (letter) => {
    const code = codeOf(letter) ?? 63;
    if (code > 126) return `\\${code.toString(8)}`;
    return '\\()'.includes(letter) ? `\\${letter}` : letter;
  });
  return `(${letters.join('')})`;
}

interface TextStyle {
  readonly size: number;
  readonly weight?: Weight;
  readonly align?: 'left' | 'middle' | 'right';
  /** Counter-clockwise. [rad] */
  readonly angle?: number;
}

const shares = {left: 0, middle: 0.5, right: 1};

/** A line of text with its baseline at a point. */
export function textAt(at: Point, text: string, style: TextStyle): string {
  const {size, weight = 'regular', align = 'left', angle = 0} = style;
  const [c, s] = towards(angle);
  const back = shares[align] * size * widthOf(text, weight);
  const begin = `BT\n/${fontNames[weight]} ${nums(size)} Tf\n${nums(-back, 0)} Td\n${shown(text)} Tj\nET`;
  return scoped(through({xx: c, xy: -s, yx: s, yy: c, shift: at}), begin);
}
