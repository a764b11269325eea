/** What content names: fonts, layers, opacities, forms and pictures, in one dictionary that all pages and forms share. */
import {num} from './pdf-content.js';
import {PdfDocument, refTo, textString, type Ref} from './pdf-document.js';
import {fontNames, type Weight} from './pdf-text.js';
import type {PdfImage} from './raster-tile.js';

const fonts: Readonly<Record<Weight, string>> = {regular: 'Helvetica', bold: 'Helvetica-Bold'};

export class PdfResources {
  readonly ref: Ref;
  readonly #document: PdfDocument;
  readonly #layers: {readonly ref: Ref; readonly name: string}[] = [];
  readonly #opacities = new Map<string, string>();
  readonly #objects: Ref[] = [];

  constructor(document: PdfDocument) {
    this.#document = document;
    this.ref = document.reserve();
  }

  /** @param name as readers list it. @returns the name in content */
  layer(name: string): string {
    const ref = this.#document.add(`<</Type/OCG/Name ${textString(name)}>>`);
    return `L${this.#layers.push({ref, name}) - 1}`;
  }

  /** Of what is filled, and of lines. */
  opacity(share: number): string {
    const value = num(share);
    const known = this.#opacities.get(value) ?? `G${this.#opacities.size}`;
    this.#opacities.set(value, known);
    return known;
  }

  /** @param more entries of its dictionary: its box, and its matrix if it has one */
  form(more: string, content: string): string {
    const entries = `/Type/XObject/Subtype/Form/Resources ${refTo(this.ref)}${more}`;
    return this.#named(this.#document.stream(entries, content));
  }

  image({entries, data}: PdfImage): string {
    return this.#named(this.#document.packedStream(entries, data));
  }

  #named(ref: Ref): string {
    return `X${this.#objects.push(ref) - 1}`;
  }

  /** Layers for the catalog, all of them seen. */
  get optionalContent(): string {
    const refs = this.#layers.map(({ref}) => refTo(ref)).join(' ');
    return `<</OCGs[${refs}]/D<</Name(Layers)/Order[${refs}]/ON[${refs}]>>>>`;
  }

  /** Once all is drawn. */
  finish(): void {
    const styles = Object.entries(fonts).map(
      ([weight, font]) =>
        `/${fontNames[weight as Weight]}<</Type/Font/Subtype/Type1/BaseFont/${font}/Encoding/WinAnsiEncoding>>`,
    );
    const layers = this.#layers.map(({ref}, k) => `/L${k} ${refTo(ref)}`);
    const states = Array.from(
      this.#opacities,
      ([value, name]) => `/${name}<</Type/ExtGState/ca ${value}/CA ${value}>>`,
    );
    const objects = this.#objects.map((ref, k) => `/X${k} ${refTo(ref)}`);
    this.#document.set(
      this.ref,
      [
        '<<',
        `/Font<<${styles.join('')}>>`,
        `/Properties<<${layers.join('')}>>`,
        `/ExtGState<<${states.join('')}>>`,
        `/XObject<<${objects.join('')}>>`,
        '>>',
      ].join('\n'),
    );
  }
}
