/** Texts of the sewing tool, loaded with the tool. */
import {loadTranslated} from './base/message.js';
import {sew as en, type SewTexts} from './en/sew.js';
import {withMessages, type Messages} from './messages.js';
import {isTouched} from './pointer.js';
import type {Language} from './preferences.js';

export type {SewTexts} from './en/sew.js';

const loaders = {
  de: () => import('./de/sew.json', {with: {type: 'json'}}),
  fr: () => import('./fr/sew.json', {with: {type: 'json'}}),
  es: () => import('./es/sew.json', {with: {type: 'json'}}),
  it: () => import('./it/sew.json', {with: {type: 'json'}}),
};

/**
 * Loads the texts of a language, with custom messages in their place.
 * @throws {Error} without network
 */
export async function loadSewTexts(language: Language, messages?: Messages): Promise<SewTexts> {
  const own = await loadTranslated(en, loaders, language);
  const sew = isTouched() ? withMessages({sew: own}, {sew: own.touch}).sew : own;
  return messages?.sew ? withMessages({sew}, {sew: messages.sew}).sew : sew;
}
