import type {Language} from '../workbench/preferences.js';
import {de} from './de.js';
import {en, type Texts} from './en.js';
import {withMessages, type Messages} from './messages.js';

export type {Texts} from './en.js';
export type {Messages} from './messages.js';

const tables: Readonly<Record<Language, Texts>> = {en, de};
const changed = new WeakMap<Messages, Map<Language, Texts>>();

/** The words of a language, but for those that somebody gives themselves. */
export function textsOf(language: Language, messages?: Messages): Texts {
  if (!messages) return tables[language];
  const known = changed.get(messages) ?? new Map<Language, Texts>();
  changed.set(messages, known);
  const texts = known.get(language) ?? withMessages(tables[language], messages);
  known.set(language, texts);
  return texts;
}
