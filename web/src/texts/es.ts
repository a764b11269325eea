/** All texts of the page in Spanish. */
import {answer} from './es/answer.js';
import {page} from './es/page.js';
import {pattern} from './es/pattern.js';
import {print} from './es/print.js';
import type {Texts} from './en.js';

export const es: Texts = {...page, ...pattern, ...answer, ...print};
