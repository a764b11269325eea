/**
 * Reads the element's inputs, from URLs or objects: garment, print, symmetries, and the prints that
 * the page offers. Files are read once, within limits; each error is a message of one sentence.
 */
import {
  askingFor,
  noPicture,
  printOf,
  type AskedSymmetry,
  type DesignGarment,
  type DesignPrint,
  type StoredFile,
} from '../../model/design/design.js';
import {symmetryList} from '../../model/design/read-design.js';
import type {FabricName} from '../../model/result/draped-garment.js';
import {SolverError, type FailureCode} from '../../model/base/failure.js';
import {colourwayOf, type Print} from '../../model/print/repeating-print.js';
import {fieldOf, Malformed} from '../../model/base/read.js';
import {repeatOf} from '../../model/print/repeat.js';
import {printOfStored} from '../../model/documents/filed-design.js';
import {FileError} from '../../model/base/versioned-file.js';
import {jsonText} from '../../solver/requests/requests.js';
import {fetchedBy} from '../../model/base/fetched.js';
import {sha256Of} from '../../model/documents/result-text.js';
import type {Texts} from '../../texts/texts.js';

export type FileWords = Texts['garment'];

/** Limit for a whole file. [ms] */
const patience = 30_000;
const megabyte = 2 ** 20;
/** Limits of an image file and of JSON; the solver reads no more than that. [MB] */
const most = {picture: 64, text: 20};

interface ReadFile {
  readonly place: StoredFile;
  readonly text: string;
}

const failure = (code: FailureCode, message: string): SolverError =>
  new SolverError({code, message});

/**
 * @throws {SolverError} `not-found`, `network`, `timeout`, `too-large`; the signal's reason when it
 * fires
 */
export async function fetchBlob(
  url: string,
  words: FileWords,
  signal?: AbortSignal,
  kind: keyof typeof most = 'picture',
): Promise<Blob> {
  const fetched = await fetchedBy(
    (either) => fetch(url, {credentials: 'same-origin', signal: either}),
    {signal, timeoutMs: patience, mostBytes: most[kind] * megabyte},
  );
  switch (fetched.kind) {
    case 'read':
      return new Blob(fetched.parts, {type: fetched.type});
    case 'refused':
      throw refused(url, fetched.status, words);
    case 'late':
      throw failure('timeout', words.timeout(url, String(patience / 1000)));
    case 'tooLarge':
      throw failure('too-large', words.tooLarge(url, `${most[kind]} MB`));
    case 'failed': {
      const {cause} = fetched;
      throw failure('network', words.network(url, cause instanceof Error ? cause.message : '?'));
    }
  }
}

const refused = (url: string, status: number, words: FileWords): SolverError =>
  status >= 400 && status < 500
    ? failure('not-found', words.notFound(url))
    : failure('network', words.network(url, `HTTP ${status}`));

/** @throws {SolverError} the errors of `fetchBlob` */
async function fetchText(url: string, words: FileWords, signal: AbortSignal): Promise<ReadFile> {
  const bytes = new Uint8Array(await (await fetchBlob(url, words, signal, 'text')).arrayBuffer());
  return {place: {url, sha256: sha256Of(bytes)}, text: new TextDecoder().decode(bytes)};
}

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

/** The last part of the path; the whole URL for one that ends with a slash. */
function nameOf(url: string): string {
  const name = new URL(url).pathname.split('/').at(-1) ?? '';
  return name === '' ? url : name;
}

function parsed(text: string, called: string, words: FileWords): unknown {
  try {
    return JSON.parse(text);
  } catch {
    throw new SolverError({code: 'notJson', message: words.notJson(called)});
  }
}

/** Reads a print. An unknown colourway selects the first. @throws {SolverError} */
function printFrom(
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

/** A print that a page offers as a choice. */
export interface OfferedPrint {
  /** Absolute URL. */
  readonly url: string;
  readonly title: string;
  /** Set once the file has been read, with the absolute URL of its image. */
  readonly print?: Print;
}

/** A URL, or one with the print's title. */
export type PrintOffer = string | {readonly url: string; readonly title?: string};

/** Reads the offers; drops those without a valid URL. */
function offeredPrints(offers: unknown): readonly OfferedPrint[] {
  if (!Array.isArray(offers)) return [];
  return (offers as readonly unknown[]).flatMap((offer) => {
    const given: unknown = typeof offer === 'string' ? {url: offer} : offer;
    const url = fieldOf(given, 'url');
    const title = fieldOf(given, 'title');
    if (typeof url !== 'string' || !URL.canParse(url, document.baseURI)) return [];
    const {href} = new URL(url, document.baseURI);
    return [{url: href, title: typeof title === 'string' ? title : ''}];
  });
}

/**
 * Reads an offered print. An unreadable one is offered without its image; choosing it shows the
 * error.
 */
async function withPrint(
  offered: OfferedPrint,
  words: FileWords,
  signal: AbortSignal,
): Promise<OfferedPrint> {
  try {
    const {place, text} = await fetchText(offered.url, words, signal);
    const print = printOf(printFrom(text, place, undefined, words));
    return {...offered, title: offered.title || (print.title ?? ''), print};
  } catch {
    return offered;
  }
}

/** The prints that an element offers. Their files are read once they are to be shown. */
export class PrintOffers {
  readonly #changed: () => void;
  #all: readonly OfferedPrint[] = [];
  #reading: AbortController | undefined;
  #isRead = true;

  constructor(changed: () => void) {
    this.#changed = changed;
  }

  get all(): readonly OfferedPrint[] {
    return this.#all;
  }

  set(offers: unknown): void {
    this.stop();
    this.#all = offeredPrints(offers);
    this.#isRead = this.#all.length === 0;
    this.#changed();
  }

  read(words: FileWords): void {
    if (this.#isRead || this.#reading) return;
    const reading = new AbortController();
    this.#reading = reading;
    const all = this.#all.map((one) => withPrint(one, words, reading.signal));
    void Promise.all(all).then((read) => {
      if (reading.signal.aborted) return;
      this.#all = read;
      this.#isRead = true;
      this.#changed();
    });
  }

  /** Stops reading; the next `read` starts again. */
  stop(): void {
    this.#reading?.abort();
    this.#reading = undefined;
  }
}
