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
export function offeredPrints(offers: unknown): readonly OfferedPrint[] {
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
export function withPrints(
  offered: readonly OfferedPrint[],
  words: FileWords,
  signal: AbortSignal,
): Promise<readonly OfferedPrint[]> {
  return Promise.all(
    offered.map(async (one) => {
      try {
        const {place, text} = await fetchText(one.url, words, signal);
        const print = printOf(printFrom(text, place, undefined, words));
        return {...one, title: one.title || (print.title ?? ''), print};
      } catch {
        return one;
      }
    }),
  );
}
