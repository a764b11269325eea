/** All texts of the page in English. Functions take formatted values. */
import {answer} from './en/answer.js';
import {page} from './en/page.js';
import {pattern} from './en/pattern.js';
import {print} from './en/print.js';

export const en = {...page, ...pattern, ...answer, ...print};

export type Texts = typeof en;
