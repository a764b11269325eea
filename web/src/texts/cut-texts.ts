/** Texts of the cutting dialog, loaded with the dialog. */
import {loadTranslated} from './base/message.js';
import {cutting as en, type CutTexts} from './en/cut.js';
import type {Language} from './preferences.js';

export type {CutTexts} from './en/cut.js';

const loaders = {
  de: () => import('./de/cut.json', {with: {type: 'json'}}),
  fr: () => import('./fr/cut.json', {with: {type: 'json'}}),
  es: () => import('./es/cut.json', {with: {type: 'json'}}),
  it: () => import('./it/cut.json', {with: {type: 'json'}}),
};

/** Loads the texts of a language. */
export const cutTexts = (language: Language): Promise<CutTexts> =>
  loadTranslated(en, loaders, language);
