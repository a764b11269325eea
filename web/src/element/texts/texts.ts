import type {Language} from '../workbench/preferences.js';
import {de} from './de.js';
import {en, type Texts} from './en.js';

export type {Texts} from './en.js';

const tables: Readonly<Record<Language, Texts>> = {en, de};

export const textsOf = (language: Language): Texts => tables[language];
