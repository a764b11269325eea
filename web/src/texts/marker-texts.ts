/** Texts of the fabric layout in all languages, loaded with its view. */
import {translated} from './base/message.js';
import de from './de/marker.json' with {type: 'json'};
import {marker as en, type MarkerTexts} from './en/marker.js';
import es from './es/marker.json' with {type: 'json'};
import fr from './fr/marker.json' with {type: 'json'};
import it from './it/marker.json' with {type: 'json'};
import {withMessages, type Messages} from './messages.js';
import type {Language} from './preferences.js';

export type {MarkerTexts} from './en/marker.js';

const tables: Readonly<Record<Language, MarkerTexts>> = {
  en,
  de: translated(en, de, 'de'),
  fr: translated(en, fr, 'fr'),
  es: translated(en, es, 'es'),
  it: translated(en, it, 'it'),
};

/** The texts of a language, with custom messages in their place. */
export function markerTexts(language: Language, messages?: Messages): MarkerTexts {
  const own = tables[language];
  return messages?.cloth ? withMessages({cloth: own}, {cloth: messages.cloth}).cloth : own;
}
