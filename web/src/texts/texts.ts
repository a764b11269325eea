import type {Language} from './preferences.js';
import {en, type Texts} from './en.js';
import {withMessages, type Messages} from './messages.js';
import {isTouched} from './pointer.js';

export type {Texts} from './en.js';
export type {Messages} from './messages.js';

/** English is always there; every other language is loaded once it is chosen. */
const loaders: Readonly<Record<Exclude<Language, 'en'>, () => Promise<Texts>>> = {
  de: async () => (await import('./de.js')).de,
  fr: async () => (await import('./fr.js')).fr,
  es: async () => (await import('./es.js')).es,
  it: async () => (await import('./it.js')).it,
};
const tables = new Map<Language, Texts>([['en', en]]);
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

/** The words of a language, English until they are loaded, but for those that somebody gives themselves. */
export function textsOf(language: Language, messages?: Messages): Texts {
  const own = tables.get(language) ?? en;
  return withThese(isTouched() ? withThese(own, own.touch) : own, messages);
}

/**
 * Loads the words of a language, so that `textsOf` has them. Without network English stays.
 * @returns whether `textsOf` has other words than before
 */
export async function loadTexts(language: Language): Promise<boolean> {
  if (language === 'en' || tables.has(language)) return false;
  try {
    tables.set(language, await loaders[language]());
    return true;
  } catch {
    return false;
  }
}
