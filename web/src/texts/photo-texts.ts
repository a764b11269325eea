/** Texts of the photo dialog in all languages, loaded with the dialog. */
import type {Failure} from '../model/result/failure.js';
import {photoFaults} from '../model/print/photo-reading.js';
import {photo as de} from './photo/de.js';
import {photo as en, type PhotoTexts} from './photo/en.js';
import {photo as es} from './photo/es.js';
import {photo as fr} from './photo/fr.js';
import {photo as it} from './photo/it.js';
import {withMessages, type Messages} from './messages.js';
import type {Language} from './preferences.js';

export type {PhotoTexts} from './photo/en.js';

const tables: Readonly<Record<Language, PhotoTexts>> = {en, de, fr, es, it};

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
