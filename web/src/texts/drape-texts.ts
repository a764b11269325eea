/** Texts of the drape, loaded with its view; translations come with those of the page. */
import {translated} from './base/message.js';
import {drape as en, type DrapeTexts} from './en/drape.js';
import {withMessages, type Messages} from './messages.js';
import type {Language} from './preferences.js';
import {drapeTranslationOf} from './texts.js';

export type {DrapeTexts} from './en/drape.js';

const tables = new Map<Language, DrapeTexts>();

function tableOf(language: Language): DrapeTexts {
  const source = drapeTranslationOf(language);
  if (!source) return en;
  const table = tables.get(language) ?? translated(en, source, language);
  tables.set(language, table);
  return table;
}

/**
 * The texts of a language, with custom messages in their place; English until the language is
 * loaded.
 */
export function drapeTexts(language: Language, messages?: Messages): DrapeTexts {
  const own = tableOf(language);
  return messages?.worn ? withMessages({worn: own}, {worn: messages.worn}).worn : own;
}
