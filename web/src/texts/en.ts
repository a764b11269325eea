/** Everything the page says, in English. Functions take what is already formatted. */
import {answer} from './en/answer.js';
import {page} from './en/page.js';
import {pattern} from './en/pattern.js';
import {print} from './en/print.js';

export const en = {...page, ...pattern, ...answer, ...print};

export type Texts = typeof en;
