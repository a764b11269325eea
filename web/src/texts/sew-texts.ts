/** What the tool that sews says: loaded with it, in one language. */
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

/** The words of a language, but for those that somebody gives themselves. @throws {Error} without network */
export async function loadSewTexts(language: Language, messages?: Messages): Promise<SewTexts> {
  const {sew: own} = await loaders[language]();
  const sew = isTouched() ? withMessages({sew: own}, {sew: own.touch}).sew : own;
  return messages?.sew ? withMessages({sew}, {sew: messages.sew}).sew : sew;
}
