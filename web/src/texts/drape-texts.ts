/** Texts of the drape in all languages, loaded with its view. */
import {worn as de} from './drape/de.js';
import {worn as en, type WornTexts} from './drape/en.js';
import {worn as es} from './drape/es.js';
import {worn as fr} from './drape/fr.js';
import {worn as it} from './drape/it.js';
import {withMessages, type Messages} from './messages.js';
import type {Language} from './preferences.js';

export type {WornTexts} from './drape/en.js';

const wornTables: Readonly<Record<Language, WornTexts>> = {en, de, fr, es, it};

/** The texts of a language, with custom messages in their place. */
export function wornTexts(language: Language, messages?: Messages): WornTexts {
  const own = wornTables[language];
  return messages?.worn ? withMessages({worn: own}, {worn: messages.worn}).worn : own;
}
