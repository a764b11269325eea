import type {Language} from '../workbench/preferences.js';
import {de} from './de.js';
import {en, type Texts} from './en.js';
import {withMessages, type Messages} from './messages.js';
import {touch} from './touch.js';

export type {Texts} from './en.js';
export type {Messages} from './messages.js';

const tables: Readonly<Record<Language, Texts>> = {en, de};
const changed = new WeakMap<Messages, Map<Texts, Texts>>();

/** One table with others' words in it, made once. */
function withThese(texts: Texts, messages: Messages | undefined): Texts {
  if (!messages) return texts;
  const known = changed.get(messages) ?? new Map<Texts, Texts>();
  changed.set(messages, known);
  const made = known.get(texts) ?? withMessages(texts, messages);
  known.set(texts, made);
  return made;
}

/** Where a finger is what points. */
const isTouched = (): boolean =>
  'matchMedia' in globalThis && matchMedia('(pointer: coarse)').matches;

/** The words of a language, but for those that somebody gives themselves. */
export function textsOf(language: Language, messages?: Messages): Texts {
  const own = tables[language];
  return withThese(isTouched() ? withThese(own, touch[language]) : own, messages);
}
