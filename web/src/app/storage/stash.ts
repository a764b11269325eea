/**
 * Keeps unsaved changes when a page is left, since a database needs more time than the page has.
 */

import {fieldOf} from '../../model/base/read.js';

const key = 'seamwise.unsaved';
/**
 * Length from which a text is written only once, even if many steps of a history contain it.
 * [characters]
 */
const longText = 1000;
/** The only field of an object that replaces a text. */
const mark = 'seamwise-text';

/** Keeps data for this tab's next page; `undefined` removes it. */
export function stash(state: unknown): void {
  sessionStorage.removeItem(key);
  if (state === undefined) return;
  const texts = new Map<string, number>();
  const data = JSON.stringify(state, (_, value: unknown) => {
    if (typeof value !== 'string' || value.length < longText) return value;
    const number = texts.get(value) ?? texts.size;
    texts.set(value, number);
    return {[mark]: number};
  });
  try {
    sessionStorage.setItem(key, JSON.stringify({data, texts: [...texts.keys()]}));
  } catch {
    // exceeds the tab's storage: the database contains all but the last moment
  }
}

/** Returns and removes the data of the previous page. */
export function unstashed(): unknown {
  const text = sessionStorage.getItem(key);
  sessionStorage.removeItem(key);
  if (text === null) return undefined;
  const {data, texts} = JSON.parse(text) as {readonly data: string; readonly texts: string[]};
  return JSON.parse(data, (_, value: unknown) => {
    const number: unknown = fieldOf(value, mark);
    return typeof number === 'number' ? texts[number] : value;
  });
}
