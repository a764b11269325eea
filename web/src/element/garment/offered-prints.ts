/** Prints that a page offers, to choose from. */
import {printOf} from '../../model/design.js';
import type {Print} from '../../model/print.js';
import {fieldOf} from '../../model/read.js';
import {fetchText, type FileWords} from './files.js';
import {printFrom} from './sources.js';

export interface OfferedPrint {
  /** Absolute. */
  readonly url: string;
  readonly title: string;
  /** Once it has been read: with the whole URL of its picture. */
  readonly print?: Print;
}

/** A URL, or one with the title that it is offered by. */
export type PrintOffer = string | {readonly url: string; readonly title?: string};

/** What has no address is left out. */
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

/** One that cannot be read is offered without its picture: choosing it says what is wrong. */
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

/** The prints that an element offers. Their files are read once somebody is to see them. */
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

  /** What has not been read yet is read when it is asked for again. */
  stop(): void {
    this.#reading?.abort();
    this.#reading = undefined;
  }
}
