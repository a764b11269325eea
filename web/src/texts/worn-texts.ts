/** Texts of the drape in all languages, loaded with its view. */
import {withMessages, type Messages} from './messages.js';
import type {Language} from './preferences.js';
import {worn as de} from './worn/de.js';
import {worn as en, type WornTexts} from './worn/en.js';
import {worn as es} from './worn/es.js';
import {worn as fr} from './worn/fr.js';
import {worn as it} from './worn/it.js';

export type {WornTexts} from './worn/en.js';

const wornTables: Readonly<Record<Language, WornTexts>> = {en, de, fr, es, it};

/** The texts of a language, with custom messages in their place. */
export function wornTexts(language: Language, messages?: Messages): WornTexts {
  const own = wornTables[language];
  return messages?.worn ? withMessages({worn: own}, {worn: messages.worn}).worn : own;
}
