/** What stands on a lay plan: loaded with what draws it, in all languages. English is there already, for programs without a page. */
import {planTexts as en, type PlanTexts} from '../marker/draw/plan-texts.js';
import {plan as de} from './plan/de.js';
import {plan as es} from './plan/es.js';
import {plan as fr} from './plan/fr.js';
import {plan as it} from './plan/it.js';
import type {Language} from './preferences.js';

const tables: Readonly<Record<Language, PlanTexts>> = {en, de, fr, es, it};

export const planTextsIn = (language: Language): PlanTexts => tables[language];
