/** Texts of the fabric layout in all languages, loaded with its view. */
import {cloth as de} from './marker/de.js';
import {cloth as en, type ClothTexts} from './marker/en.js';
import {cloth as es} from './marker/es.js';
import {cloth as fr} from './marker/fr.js';
import {cloth as it} from './marker/it.js';
import {withMessages, type Messages} from './messages.js';
import type {Language} from './preferences.js';

export type {ClothTexts} from './marker/en.js';

const tables: Readonly<Record<Language, ClothTexts>> = {en, de, fr, es, it};

/** The texts of a language, with custom messages in their place. */
export function clothTexts(language: Language, messages?: Messages): ClothTexts {
  const own = tables[language];
  return messages?.cloth ? withMessages({cloth: own}, {cloth: messages.cloth}).cloth : own;
}
