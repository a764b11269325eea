/**
 * Resources of content streams: fonts, layers, opacities, forms and images, in one dictionary
 * shared by all pages and forms.
 */
import {num} from './content.js';
import {PdfDocument, refTo, textString, type Ref} from './document.js';
import type {OtherLetters} from './fonts/other-letters.js';
import {TextFonts} from './text-fonts.js';
import type {PdfImage} from './image.js';

export class PdfResources {
  readonly ref: Ref;
  readonly fonts: TextFonts;
  readonly #document: PdfDocument;
  readonly #layers: {readonly ref: Ref; readonly isShown: boolean}[] = [];
  readonly #opacities = new Map<string, string>();
  readonly #objects: Ref[] = [];

  constructor(document: PdfDocument) {
    this.#document = document;
    this.ref = document.reserve();
    this.fonts = new TextFonts(document);
  }

  /**
   * Adds a layer.
   * @param name layer name in viewers
   * @param isShown whether viewers show it at first
   * @returns the name in content
   */
  layer(name: string, isShown = true): string {
    const ref = this.#document.add(`<</Type/OCG/Name ${textString(name)}>>`);
    return `L${this.#layers.push({ref, isShown}) - 1}`;
  }

  /** The graphics state for an opacity of fills and strokes. */
  opacity(share: number): string {
    const value = num(share);
    const known = this.#opacities.get(value) ?? `G${this.#opacities.size}`;
    this.#opacities.set(value, known);
    return known;
  }

  /**
   * Adds a form.
   * @param more further entries of its dictionary: bounding box and optional matrix
   * @returns the name in content
   */
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

  /** Layers for the catalog. */
  get optionalContent(): string {
    const refs = (wanted: (isShown: boolean) => boolean): string =>
      this.#layers
        .filter(({isShown}) => wanted(isShown))
        .map(({ref}) => refTo(ref))
        .join(' ');
    const [all, on, off] = [refs(() => true), refs((is) => is), refs((is) => !is)];
    const hidden = off === '' ? '' : `/OFF[${off}]`;
    return `<</OCGs[${all}]/D<</Name(Layers)/Order[${all}]/ON[${on}]${hidden}>>>>`;
  }

  /**
   * Writes the dictionary after everything is drawn.
   * @returns letters that no font has
   */
  async finish(others?: OtherLetters): Promise<readonly string[]> {
    const {fonts, objects: words, missing} = await this.fonts.finish(this.ref, others);
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
        `/Font<<${fonts.join('')}>>`,
        `/Properties<<${layers.join('')}>>`,
        `/ExtGState<<${states.join('')}>>`,
        `/XObject<<${[...objects, ...words].join('')}>>`,
        '>>',
      ].join('\n'),
    );
    return missing;
  }
}
