/** Texts of a drawn layout in all languages, loaded with the drawing code. */
import {translated} from './base/message.js';
import de from './de/plan.json' with {type: 'json'};
import {plan as en, type PlanTexts} from './en/plan.js';
import es from './es/plan.json' with {type: 'json'};
import fr from './fr/plan.json' with {type: 'json'};
import it from './it/plan.json' with {type: 'json'};
import type {Language} from './preferences.js';

const tables: Readonly<Record<Language, PlanTexts>> = {
  en,
  de: translated(en, de, 'de'),
  fr: translated(en, fr, 'fr'),
  es: translated(en, es, 'es'),
  it: translated(en, it, 'it'),
};

export const planTextsIn = (language: Language): PlanTexts => tables[language];
