/** Texts of the import dialog in one language, loaded with the dialog. */
import type {ImportTexts} from './import/en.js';
import type {Language} from './preferences.js';

export type {ImportTexts} from './import/en.js';

const loaders: Readonly<Record<Language, () => Promise<{readonly importing: ImportTexts}>>> = {
  en: () => import('./import/en.js'),
  de: () => import('./import/de.js'),
  fr: () => import('./import/fr.js'),
  es: () => import('./import/es.js'),
  it: () => import('./import/it.js'),
};

export const importTexts = async (language: Language): Promise<ImportTexts> =>
  (await loaders[language]()).importing;
