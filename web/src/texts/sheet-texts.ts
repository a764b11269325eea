/** Texts of a cutting sheet in all languages, loaded with the drawing code. */
import {translated} from './base/message.js';
import de from './de/sheet.json' with {type: 'json'};
import {sheet as en, type SheetTexts} from './en/sheet.js';
import es from './es/sheet.json' with {type: 'json'};
import fr from './fr/sheet.json' with {type: 'json'};
import it from './it/sheet.json' with {type: 'json'};

export type {SheetTexts} from './en/sheet.js';

const tables: Readonly<Record<string, SheetTexts>> = {
  en,
  de: translated(en, de, 'de'),
  fr: translated(en, fr, 'fr'),
  es: translated(en, es, 'es'),
  it: translated(en, it, 'it'),
};

/** The texts for a locale such as `de` or `de-CH`; English ones for other languages. */
export const sheetTextsIn = (locale = 'en'): SheetTexts => tables[locale.slice(0, 2)] ?? en;
