/** Prints that a page offers as a choice. */
import {printOf} from '../../model/design/design.js';
import type {Print} from '../../model/print/repeating-print.js';
import {fieldOf} from '../../model/base/read.js';
import {fetchText, type FileWords} from './files.js';
import {printFrom} from './sources.js';

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
