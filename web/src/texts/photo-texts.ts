/** Texts of the photo dialog in all languages, loaded with the dialog. */
import type {Failure} from '../model/base/failure.js';
import {photoFaults} from '../model/base/failure.js';
import {translated} from './base/message.js';
import de from './de/photo.json' with {type: 'json'};
import {photo as en, type PhotoTexts} from './en/photo.js';
import es from './es/photo.json' with {type: 'json'};
import fr from './fr/photo.json' with {type: 'json'};
import it from './it/photo.json' with {type: 'json'};
import {withMessages, type Messages} from './messages.js';
import type {Language} from './preferences.js';

export type {PhotoTexts} from './en/photo.js';

const tables: Readonly<Record<Language, PhotoTexts>> = {
  en,
  de: translated(en, de, 'de'),
  fr: translated(en, fr, 'fr'),
  es: translated(en, es, 'es'),
  it: translated(en, it, 'it'),
};

/** The texts of a language, with custom messages in their place. */
export function photoTexts(language: Language, messages?: Messages): PhotoTexts {
  const own = tables[language];
  return messages?.photo ? withMessages({photo: own}, {photo: messages.photo}).photo : own;
}

/** Returns the message of a failure, in the page's language for a failure of the photo reader. */
export function saidFailure({faults}: PhotoTexts, {reason, message}: Failure): string {
  const fault = photoFaults.find((known) => known === reason);
  return fault ? faults[fault] : message;
}
