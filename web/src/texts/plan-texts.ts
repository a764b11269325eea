/**
 * Texts of a drawn layout in all languages, loaded with the drawing code. The English ones are in
 * `marker/draw`, for programs without a page.
 */
import {planTexts as en, type PlanTexts} from '../marker/draw/plan-texts.js';
import {plan as de} from './plan/de.js';
import {plan as es} from './plan/es.js';
import {plan as fr} from './plan/fr.js';
import {plan as it} from './plan/it.js';
import type {Language} from './preferences.js';

const tables: Readonly<Record<Language, PlanTexts>> = {en, de, fr, es, it};

export const planTextsIn = (language: Language): PlanTexts => tables[language];
