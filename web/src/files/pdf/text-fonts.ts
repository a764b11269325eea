/** The fonts of a PDF file: an embedded font, and other letters as forms. */
import {num, nums, scoped} from './content.js';
import {refTo, type PdfDocument, type Ref} from './document.js';
import {EmbeddedFont} from './embedded-font.js';
import {codeOf, plainLetters, runsOf, sansGlyph, widthOf, type Weight} from './fonts/letters.js';
import type {LettersPicture, NamedFont, OtherLetters} from './fonts/other-letters.js';
import {readTrueType, type TrueType} from './fonts/true-type.js';

const fontNames: Readonly<Record<Weight, string>> = {
  regular: 'LiberationSans',
  bold: 'LiberationSans-Bold',
};

/** Letters of another script, drawn by a form at font size 1 with its baseline at the origin. */
interface OtherRun {
  readonly text: string;
  readonly name: string;
  readonly ref: Ref;
}

/** Entries of resources by which a viewer finds the fonts. */
interface FontEntries {
  readonly fonts: readonly string[];
  readonly objects: readonly string[];
  /** Letters that no font has. */
  readonly missing: readonly string[];
}

async function sansFont(weight: Weight): Promise<TrueType> {
  const {sansOutlines} = await import('./fonts/sans-outlines.js');
  const packed = Uint8Array.from(atob(sansOutlines[weight]), (letter) => letter.charCodeAt(0));
  const through = new Blob([packed]).stream().pipeThrough(new DecompressionStream('deflate'));
  const bytes = new Uint8Array(await new Response(through).arrayBuffer());
  return {...(await readTrueType(bytes, fontNames[weight])), glyphOf: sansGlyph};
}

export class TextFonts {
  readonly #document: PdfDocument;
  readonly #sans: Readonly<Record<Weight, EmbeddedFont>>;
  readonly #others = new Map<string, OtherRun>();

  constructor(document: PdfDocument) {
    this.#document = document;
    this.#sans = {
      regular: new EmbeddedFont(document, 0),
      bold: new EmbeddedFont(document, 1),
    };
  }

  /** Operators that draw a line of text from the origin. */
  shown(text: string, size: number, weight: Weight): string {
    let x = 0;
    const parts = runsOf(text).map((run) => {
      const at = x;
      x += size * widthOf(run.text, weight);
      if (!run.isSans) {
        const form = `${nums(size, 0, 0, size, at, 0)} cm\n/${this.#other(run.text).name} Do`;
        return scoped(form);
      }
      const font = this.#sans[weight];
      return `BT\n/${font.name} ${num(size)} Tf\n${nums(at, 0)} Td\n${font.coded(run.text)} Tj\nET`;
    });
    return parts.join('\n');
  }

  #other(text: string): OtherRun {
    const known = this.#others.get(text);
    if (known) return known;
    const run = {text, name: `W${this.#others.size}`, ref: this.#document.reserve()};
    this.#others.set(text, run);
    return run;
  }

  /** Writes the fonts after everything is drawn. */
  async finish(resources: Ref, {pictureOf, fontFor}: OtherLetters = {}): Promise<FontEntries> {
    const missing = new Set<string>();
    const fonts = new Map<NamedFont, EmbeddedFont>();
    for (const run of this.#others.values()) {
      const picture = pictureOf?.(run.text);
      if (picture) this.#drawPicture(run, picture);
      else await this.#write(run, resources, {fontFor, fonts, missing});
    }
    const written: string[] = [];
    for (const weight of ['regular', 'bold'] as const) {
      const font = this.#sans[weight];
      if (!font.isUsed) continue;
      const ref = font.write(await sansFont(weight), fontNames[weight]);
      written.push(`/${font.name} ${refTo(ref)}`);
    }
    for (const [{font, name}, embedded] of fonts) {
      written.push(`/${embedded.name} ${refTo(embedded.write(font, name))}`);
    }
    return {
      fonts: written,
      objects: Array.from(this.#others.values(), ({name, ref}) => `/${name} ${refTo(ref)}`),
      missing: [...missing],
    };
  }

  /** Writes a run in fonts that have its letters; a letter without one keeps its base letter. */
  async #write(
    {text, ref}: OtherRun,
    resources: Ref,
    {
      fontFor,
      fonts,
      missing,
    }: {
      readonly fontFor: OtherLetters['fontFor'];
      readonly fonts: Map<NamedFont, EmbeddedFont>;
      readonly missing: Set<string>;
    },
  ): Promise<void> {
    const shown: string[] = [];
    let width = 0;
    for (const letter of plainLetters(text)) {
      const found = await fontFor?.(letter);
      if (found) {
        const known = fonts.get(found) ?? new EmbeddedFont(this.#document, 2 + fonts.size);
        fonts.set(found, known);
        shown.push(`/${known.name} 1 Tf ${known.coded(letter)} Tj`);
        const {glyphOf, widthOf: advance, unitsPerEm} = found.font;
        width += advance(glyphOf(codeOf(letter))) / unitsPerEm;
        continue;
      }
      const [base = ''] = letter.normalize('NFD');
      const plain = sansGlyph(codeOf(base)) > 0 ? base : '?';
      if (letter !== ' ') missing.add(letter);
      shown.push(`/${this.#sans.regular.name} 1 Tf ${this.#sans.regular.coded(plain)} Tj`);
      width += widthOf(plain);
    }
    const room = widthOf(text);
    const narrow = width > room && room > 0 ? `${num(room / width)} 0 0 1 0 0 cm\n` : '';
    this.#document.setStream(
      ref,
      `/Type/XObject/Subtype/Form/BBox[-1 -1 ${num(room + 1)} 2]/Resources ${refTo(resources)}`,
      `${narrow}BT\n${shown.join('\n')}\nET`,
    );
  }

  #drawPicture({text, ref}: OtherRun, picture: LettersPicture): void {
    const {width, height, bits, perEm, baseline} = picture;
    const mask = this.#document.stream(
      `/Type/XObject/Subtype/Image/Width ${width}/Height ${height}/ImageMask true/BitsPerComponent 1/Decode[1 0]`,
      bits,
    );
    const room = widthOf(text);
    const across = Math.min(width / perEm, room > 0 ? room : Infinity);
    const matrix = nums(across, 0, 0, height / perEm, 0, (baseline - height) / perEm);
    this.#document.setStream(
      ref,
      [
        `/Type/XObject/Subtype/Form/BBox[-1 -1 ${num(room + 1)} 2]`,
        `/Resources<</XObject<</I ${refTo(mask)}>>>>`,
      ].join(''),
      `${matrix} cm\n/I Do`,
    );
  }
}
