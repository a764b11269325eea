/** Texts of the import dialog, loaded with the dialog. */
import {drawingFaults, type Failure} from '../model/base/failure.js';
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

/**
 * The message on a file that is no pattern, in the user's language, or in English without a known
 * reason.
 */
export function saidRefusal(
  {complaints}: ImportTexts,
  {reason, message}: {readonly reason?: Failure['reason'] | undefined; readonly message: string},
  file: string,
): string {
  const fault = drawingFaults.find((known) => known === reason);
  return fault ? complaints[fault](file) : message;
}
