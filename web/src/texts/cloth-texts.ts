/** Texts of the fabric layout in all languages, loaded with its view. */
import {cloth as de} from './cloth/de.js';
import {cloth as en, type ClothTexts} from './cloth/en.js';
import {cloth as es} from './cloth/es.js';
import {cloth as fr} from './cloth/fr.js';
import {cloth as it} from './cloth/it.js';
import {withMessages, type Messages} from './messages.js';
import type {Language} from './preferences.js';

export type {ClothTexts} from './cloth/en.js';

const tables: Readonly<Record<Language, ClothTexts>> = {en, de, fr, es, it};

/** The texts of a language, with custom messages in their place. */
export function clothTexts(language: Language, messages?: Messages): ClothTexts {
  const own = tables[language];
  return messages?.cloth ? withMessages({cloth: own}, {cloth: messages.cloth}).cloth : own;
}
