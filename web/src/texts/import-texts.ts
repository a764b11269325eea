/** Texts of the import dialog, loaded with the dialog. */
import {loadTranslated} from './base/message.js';
import {importing as en, type ImportTexts} from './en/import.js';
import type {Language} from './preferences.js';

export type {ImportTexts} from './en/import.js';

const loaders = {
  de: () => import('./de/import.json', {with: {type: 'json'}}),
  fr: () => import('./fr/import.json', {with: {type: 'json'}}),
  es: () => import('./es/import.json', {with: {type: 'json'}}),
  it: () => import('./it/import.json', {with: {type: 'json'}}),
};

/** Loads the texts of a language. */
export const importTexts = (language: Language): Promise<ImportTexts> =>
  loadTranslated(en, loaders, language);
