/** All texts of the page in German. */
import {answer} from './de/answer.js';
import {page} from './de/page.js';
import {pattern} from './de/pattern.js';
import {print} from './de/print.js';
import type {Texts} from './en.js';

export const de: Texts = {...page, ...pattern, ...answer, ...print};
