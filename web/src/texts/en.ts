/** All texts of the page in English. Functions take formatted values. */
import {answer} from './en/answer.js';
import {page} from './en/page.js';
import {pattern} from './en/pattern.js';
import {print} from './en/print.js';
import {samples} from './en/samples.js';

export const en = {...page, ...pattern, ...answer, ...print, ...samples};

export type Texts = typeof en;
