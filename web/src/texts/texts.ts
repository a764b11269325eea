import type {Language} from './preferences.js';
import type {Translation} from './base/message.js';
import type {DrapeTexts} from './en/drape.js';
import {en, type Texts} from './en.js';
import {withMessages, type Messages} from './messages.js';
import {isTouched} from './pointer.js';

export type {Texts} from './en.js';
export type {Messages} from './messages.js';

type DrapeTranslation = Translation<DrapeTexts>;

interface LoadedTexts {
  readonly texts: Texts;
  readonly drape: DrapeTranslation;
}

/** English is included; other languages are loaded when they are chosen. */
const loaders: Readonly<Record<Exclude<Language, 'en'>, () => Promise<LoadedTexts>>> = {
  de: async () => {
    const {de: texts, drape} = await import('./de.js');
    return {texts, drape};
  },
  fr: async () => {
    const {fr: texts, drape} = await import('./fr.js');
    return {texts, drape};
  },
  es: async () => {
    const {es: texts, drape} = await import('./es.js');
    return {texts, drape};
  },
  it: async () => {
    const {it: texts, drape} = await import('./it.js');
    return {texts, drape};
  },
};
const tables = new Map<Language, Texts>([['en', en]]);
const drapes = new Map<Language, DrapeTranslation>();
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

/** Translation of the drape's texts; undefined for English, and until the language is loaded. */
export const drapeTranslationOf = (language: Language): DrapeTranslation | undefined =>
  drapes.get(language);

/**
 * Loads the texts of a language for `textsOf`. Without network, English stays.
 * @returns whether the texts of `textsOf` changed
 */
export async function loadTexts(language: Language): Promise<boolean> {
  if (language === 'en' || tables.has(language)) return false;
  try {
    const {texts, drape} = await loaders[language]();
    tables.set(language, texts);
    drapes.set(language, drape);
    return true;
  } catch {
    return false;
  }
}
