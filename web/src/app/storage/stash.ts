/** What was not kept yet when a page is left: a database takes longer than such a page has. */

import {fieldOf} from '../../model/read.js';

const key = 'seamwise.unsaved';
/** Longer texts are written once, however many steps of a history hold them. [characters] */
const longText = 1000;
/** The one field of an object that stands for a text. */
const mark = 'seamwise-text';

/** For this tab's next page; `undefined` takes back what was left before. */
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
    // more than a tab can remember: all but the last moment is in the database
  }
}

/** What the page before left, once. */
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
