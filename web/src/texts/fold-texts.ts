/** Texts of the tool for folds, loaded with the tool. */
import {loadTranslated} from './base/message.js';
import {fold as en, type FoldTexts} from './en/fold.js';
import {withMessages, type Messages} from './messages.js';
import {isTouched} from './pointer.js';
import type {Language} from './preferences.js';

export type {FoldTexts} from './en/fold.js';

const loaders = {
  de: () => import('./de/fold.json', {with: {type: 'json'}}),
  fr: () => import('./fr/fold.json', {with: {type: 'json'}}),
  es: () => import('./es/fold.json', {with: {type: 'json'}}),
  it: () => import('./it/fold.json', {with: {type: 'json'}}),
};

/**
 * Loads the texts of a language, with custom messages in their place.
 * @throws {Error} without network
 */
export async function loadFoldTexts(language: Language, messages?: Messages): Promise<FoldTexts> {
  const own = await loadTranslated(en, loaders, language);
  const fold = isTouched() ? withMessages({fold: own}, {fold: own.touch}).fold : own;
  return messages?.fold ? withMessages({fold}, {fold: messages.fold}).fold : fold;
}
