import type {Language} from './preferences.js';
import {en, type Texts} from './en.js';
import {withMessages, type Messages} from './messages.js';
import {isTouched} from './pointer.js';

export type {Texts} from './en.js';
export type {Messages} from './messages.js';

/** English is included; other languages are loaded when they are chosen. */
const loaders: Readonly<Record<Exclude<Language, 'en'>, () => Promise<Texts>>> = {
  de: async () => (await import('./de.js')).de,
  fr: async () => (await import('./fr.js')).fr,
  es: async () => (await import('./es.js')).es,
  it: async () => (await import('./it.js')).it,
};
const tables = new Map<Language, Texts>([['en', en]]);
const changed = new WeakMap<Messages, Map<Texts, Texts>>();

/** The texts merged with messages, cached. */
function withThese(texts: Texts, messages: Messages | undefined): Texts {
  if (!messages) return texts;
  const known = changed.get(messages) ?? new Map<Texts, Texts>();
  changed.set(messages, known);
  const made = known.get(texts) ?? withMessages(texts, messages);
  known.set(texts, made);
  return made;
}

/**
 * The texts of a language with custom messages in their place; English until the language is
 * loaded.
 */
export function textsOf(language: Language, messages?: Messages): Texts {
  const own = tables.get(language) ?? en;
  return withThese(isTouched() ? withThese(own, own.touch) : own, messages);
}

/**
 * Loads the texts of a language for `textsOf`. Without network, English stays.
 * @returns whether the texts of `textsOf` changed
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
