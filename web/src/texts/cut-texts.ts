/** Texts of the cutting dialog in one language, loaded with the dialog. */
import type {CutTexts} from './cut/en.js';
import type {Language} from './preferences.js';

export type {CutTexts} from './cut/en.js';

const loaders: Readonly<Record<Language, () => Promise<{readonly cutting: CutTexts}>>> = {
  en: () => import('./cut/en.js'),
  de: () => import('./cut/de.js'),
  fr: () => import('./cut/fr.js'),
  es: () => import('./cut/es.js'),
  it: () => import('./cut/it.js'),
};

export const cutTexts = async (language: Language): Promise<CutTexts> =>
  (await loaders[language]()).cutting;
