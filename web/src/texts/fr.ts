import {answer} from './fr/answer.js';
import {page} from './fr/page.js';
import {pattern} from './fr/pattern.js';
import {print} from './fr/print.js';
import type {Texts} from './en.js';

export const fr: Texts = {...page, ...pattern, ...answer, ...print};
