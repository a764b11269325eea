/** A font of a PDF file with the letters that the file contains. */
import {refTo, type PdfDocument, type Ref} from './document.js';
import {codeOf, plainLetters} from './fonts/letters.js';
import {subsetOf} from './fonts/subset.js';
import type {TrueType} from './fonts/true-type.js';

const hex = (value: number): string => value.toString(16).padStart(4, '0');

/** UTF-16 code units of a letter. */
const unitsOf = (letter: string): string =>
  Array.from({length: letter.length}, (_, k) => hex(letter.charCodeAt(k))).join('');

/** Longest list of a character map. */
const mostInList = 100;

/** Maps the codes of content streams to letters, for search and copies. */
function letterMap(letters: readonly string[]): string {
  const lists: string[] = [];
  for (let from = 0; from < letters.length; from += mostInList) {
    const some = letters.slice(from, from + mostInList);
    const lines = some.map((letter, k) => `<${hex(from + k + 1)}> <${unitsOf(letter)}>`);
    lists.push(`${some.length} beginbfchar\n${lines.join('\n')}\nendbfchar`);
  }
  return [
    '/CIDInit /ProcSet findresource begin\n12 dict begin\nbegincmap',
    '/CIDSystemInfo<</Registry(Adobe)/Ordering(UCS)/Supplement 0>>def',
    '/CMapName/Adobe-Identity-UCS def\n/CMapType 2 def',
    '1 begincodespacerange\n<0000> <ffff>\nendcodespacerange',
    ...lists,
    'endcmap\nCMapName currentdict /CMap defineresource pop\nend\nend',
  ].join('\n');
}

/** The prefix of a subset's name, six letters. */
const prefixOf = (index: number): string =>
  `SEAM${[Math.floor(index / 26), index % 26].map((k) => String.fromCharCode(65 + k)).join('')}`;

export class EmbeddedFont {
  /** Name in content streams. */
  readonly name: string;
  readonly #prefix: string;
  readonly #document: PdfDocument;
  /** Codes by letter, in order of use from 1; glyph 0 is the missing letter. */
  readonly #codes = new Map<string, number>();

  /** @param index number among the fonts of the file */
  constructor(document: PdfDocument, index: number) {
    this.#document = document;
    this.name = `T${index}`;
    this.#prefix = prefixOf(index);
  }

  get isUsed(): boolean {
    return this.#codes.size > 0;
  }

  /** The text as a string of a content stream. */
  coded(text: string): string {
    const codes = plainLetters(text).map((letter) => {
      const code = this.#codes.get(letter) ?? this.#codes.size + 1;
      this.#codes.set(letter, code);
      return hex(code);
    });
    return `<${codes.join('')}>`;
  }

  /** Writes the font with the letters of all texts so far. */
  write(font: TrueType, called: string): Ref {
    const document = this.#document;
    const letters = [...this.#codes.keys()];
    const glyphs = letters.map((letter) => font.glyphOf(codeOf(letter)));
    const scale = 1000 / font.unitsPerEm;
    const scaled = (value: number): number => Math.round(scale * value);
    const name = `/${this.#prefix}+${called}`;
    const file = document.stream('', subsetOf(font, [0, ...glyphs]));
    const descriptor = document.add(
      [
        `<</Type/FontDescriptor/FontName${name}/Flags 4/ItalicAngle 0/StemV 80`,
        `/FontBBox[${font.box.map(scaled).join(' ')}]/Ascent ${scaled(font.ascent)}`,
        `/Descent ${scaled(font.descent)}/CapHeight ${scaled(font.ascent)}/FontFile2 ${refTo(file)}>>`,
      ].join(''),
    );
    const widths = glyphs.map((glyph) => scaled(font.widthOf(glyph))).join(' ');
    const shapes = document.add(
      [
        `<</Type/Font/Subtype/CIDFontType2/BaseFont${name}/CIDToGIDMap/Identity`,
        '/CIDSystemInfo<</Registry(Adobe)/Ordering(Identity)/Supplement 0>>',
        `/FontDescriptor ${refTo(descriptor)}/W[1[${widths}]]>>`,
      ].join(''),
    );
    return document.add(
      [
        `<</Type/Font/Subtype/Type0/BaseFont${name}/Encoding/Identity-H`,
        `/DescendantFonts[${refTo(shapes)}]/ToUnicode ${refTo(document.stream('', letterMap(letters)))}>>`,
      ].join(''),
    );
  }
}
