/** Reads the element's inputs: garment, print and symmetries, from URLs or objects. */
import {
  askingFor,
  noPicture,
  type AskedSymmetry,
  type DesignGarment,
  type DesignPrint,
  type StoredFile,
} from '../../model/design/design.js';
import {symmetryList} from '../../model/design/read-design.js';
import type {FabricName} from '../../model/result/draped-garment.js';
import {SolverError} from '../../model/result/failure.js';
import {colourwayOf, type Print} from '../../model/print/repeating-print.js';
import {fieldOf, Malformed} from '../../model/base/read.js';
import {repeatOf} from '../../model/print/repeat.js';
import {printOfStored} from '../../model/documents/stored-design.js';
import {FileError} from '../../model/base/versioned-file.js';
import {jsonText} from '../../solver/requests/texts.js';
import {fetchText, type FileWords} from './files.js';

/** A request. Strings are URLs, relative to the document. */
export interface Asked {
  readonly garment: string | object | undefined;
  /** Replaces `{size}` in the garment's URL. */
  readonly size: string | undefined;
  readonly print: string | object | undefined;
  readonly colourway: string | undefined;
  /** `auto`, `none`, a URL, or the symmetries. */
  readonly symmetry: string | object;
  /** [cm] */
  readonly maxChangeCm: number;
  readonly fabric: FabricName;
}

/** Loaded inputs; unchanged inputs are the same objects as before. */
export interface Loaded {
  readonly garment: DesignGarment;
  readonly print: DesignPrint;
  readonly symmetry: AskedSymmetry;
}

/** Caches the last value by its inputs. */
class Kept<T> {
  #last: {readonly from: readonly unknown[]; readonly value: T} | undefined;

  async of(from: readonly unknown[], read: () => Promise<T>): Promise<T> {
    if (!this.#last?.from.every((part, k) => part === from[k])) {
      this.#last = {from, value: await read()};
    }
    return this.#last.value;
  }
}

export class Sources {
  readonly #words: () => FileWords;
  readonly #garment = new Kept<DesignGarment>();
  readonly #print = new Kept<DesignPrint>();
  readonly #symmetry = new Kept<AskedSymmetry>();

  constructor(words: () => FileWords) {
    this.#words = words;
  }

  /** @throws {SolverError} a message of one sentence; the signal's reason when it fires */
  async load(asked: Asked, signal: AbortSignal): Promise<Loaded> {
    const [garment, print, symmetry] = await Promise.all([
      this.#readGarment(asked, signal),
      this.#readPrint(asked, signal),
      this.#readSymmetry(asked, signal),
    ]);
    return {garment, print, symmetry};
  }

  async #readGarment({garment, size}: Asked, signal: AbortSignal): Promise<DesignGarment> {
    const words = this.#words();
    if (garment === undefined) {
      throw new SolverError({code: 'notAGarment', message: words.noGarment});
    }
    return this.#garment.of([garment, size], async () => {
      if (typeof garment === 'object') return {name: 'garment', text: jsonText(garment, 'garment')};
      if (size === undefined && garment.includes('{size}')) {
        throw new SolverError({code: 'not-found', message: words.noSize(garment)});
      }
      const named = garmentUrl(garment, size);
      const {place, text} = await fetchText(absolute(named, words), words, signal);
      return {name: nameOf(place.url), text, file: {...place, ...(size !== undefined && {size})}};
    });
  }

  async #readPrint({print, colourway}: Asked, signal: AbortSignal): Promise<DesignPrint> {
    const words = this.#words();
    if (print === undefined) throw new SolverError({code: 'notAPrint', message: words.noGarment});
    return this.#print.of([print, colourway], async () => {
      if (typeof print === 'object') {
        return printFrom(jsonText(print, 'print'), undefined, colourway, words);
      }
      const {place, text} = await fetchText(absolute(print, words), words, signal);
      return printFrom(text, place, colourway, words);
    });
  }

  async #readSymmetry({symmetry}: Asked, signal: AbortSignal): Promise<AskedSymmetry> {
    if (symmetry === 'auto' || symmetry === 'none') return symmetry;
    return this.#symmetry.of([symmetry], async () => {
      if (typeof symmetry === 'object') return this.#symmetriesIn(symmetry, 'symmetry');
      const words = this.#words();
      const {text, place} = await fetchText(absolute(symmetry, words), words, signal);
      return this.#symmetriesIn(parsed(text, place.url, words), place.url);
    });
  }

  #symmetriesIn(value: unknown, called: string): AskedSymmetry {
    try {
      const list = Array.isArray(value) ? value : fieldOf(value, 'symmetries');
      return askingFor(symmetryList(list, called));
    } catch (error) {
      if (!(error instanceof Malformed)) throw error;
      const message = this.#words().noSymmetries(called);
      throw new SolverError({code: 'symmetryMalformed', message});
    }
  }
}

/** Returns the URL of one size's file. */
export const garmentUrl = (template: string, size: string | undefined): string =>
  size === undefined ? template : template.replaceAll('{size}', encodeURIComponent(size));

function absolute(url: string, words: FileWords): string {
  if (URL.canParse(url, document.baseURI)) return new URL(url, document.baseURI).href;
  throw new SolverError({code: 'not-found', message: words.noAddress(url)});
}

const nameOf = (url: string): string => new URL(url).pathname.split('/').at(-1) ?? url;

function parsed(text: string, called: string, words: FileWords): unknown {
  try {
    return JSON.parse(text);
  } catch {
    throw new SolverError({code: 'notJson', message: words.notJson(called)});
  }
}

/** Reads a print. An unknown colourway selects the first. @throws {SolverError} */
export function printFrom(
  text: string,
  place: StoredFile | undefined,
  wanted: string | undefined,
  words: FileWords,
): DesignPrint {
  const called = place?.url ?? 'print';
  if (!/^\s*\{/.test(text)) {
    throw new SolverError({code: 'notAPrint', message: words.noPrint(called)});
  }
  const file = checked(text, place);
  const worn = wanted === undefined ? undefined : colourwayOf(file, wanted);
  const {title, group, oneWay = false, cell = 'primitive', unscaled} = file;
  const image = worn?.image ?? file.image;
  const base = place?.url ?? document.baseURI;
  return {
    title: typeof title === 'string' ? title : group,
    ...{group, oneWay, cell, ...repeatOf(file), ...(unscaled && {unscaled})},
    image: image && URL.canParse(image, base) ? new URL(image, base).href : noPicture,
    file: {text, ...(place && {place}), ...(worn && {colourway: worn.name})},
  };
}

function checked(text: string, place: StoredFile | undefined): Print {
  try {
    return printOfStored({print: place ?? {url: 'print', sha256: ''}}, text);
  } catch (error) {
    if (!(error instanceof FileError)) throw error;
    throw new SolverError({code: 'notAPrint', message: error.message});
  }
}
