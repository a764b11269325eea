/** Texts of the sewing tool in one language, loaded with the tool. */
import {withMessages, type Messages} from './messages.js';
import {isTouched} from './pointer.js';
import type {Language} from './preferences.js';
import type {SewTexts} from './sew/en.js';

export type {SewTexts} from './sew/en.js';

const loaders: Readonly<Record<Language, () => Promise<{readonly sew: SewTexts}>>> = {
  en: () => import('./sew/en.js'),
  de: () => import('./sew/de.js'),
  fr: () => import('./sew/fr.js'),
  es: () => import('./sew/es.js'),
  it: () => import('./sew/it.js'),
};

/**
 * Loads the texts of a language, with custom messages in their place.
 * @throws {Error} without network
 */
export async function loadSewTexts(language: Language, messages?: Messages): Promise<SewTexts> {
  const {sew: own} = await loaders[language]();
  const sew = isTouched() ? withMessages({sew: own}, {sew: own.touch}).sew : own;
  return messages?.sew ? withMessages({sew}, {sew: messages.sew}).sew : sew;
}
