/** Texts of the drape in all languages, loaded with its view. */
import {translated} from './base/message.js';
import de from './de/drape.json' with {type: 'json'};
import {drape as en, type DrapeTexts} from './en/drape.js';
import es from './es/drape.json' with {type: 'json'};
import fr from './fr/drape.json' with {type: 'json'};
import it from './it/drape.json' with {type: 'json'};
import {withMessages, type Messages} from './messages.js';
import type {Language} from './preferences.js';

export type {DrapeTexts} from './en/drape.js';

const drapeTables: Readonly<Record<Language, DrapeTexts>> = {
  en,
  de: translated(en, de, 'de'),
  fr: translated(en, fr, 'fr'),
  es: translated(en, es, 'es'),
  it: translated(en, it, 'it'),
};

/** The texts of a language, with custom messages in their place. */
export function drapeTexts(language: Language, messages?: Messages): DrapeTexts {
  const own = drapeTables[language];
  return messages?.worn ? withMessages({worn: own}, {worn: messages.worn}).worn : own;
}
