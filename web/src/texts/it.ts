/** All texts of the page in Italian. */
import {answer} from './it/answer.js';
import {page} from './it/page.js';
import {pattern} from './it/pattern.js';
import {print} from './it/print.js';
import type {Texts} from './en.js';

export const it: Texts = {...page, ...pattern, ...answer, ...print};
