/** All texts of the page in Spanish. */
import {translated} from './base/message.js';
import answer from './es/answer.json' with {type: 'json'};
import drape from './es/drape.json' with {type: 'json'};
import page from './es/page.json' with {type: 'json'};
import pattern from './es/pattern.json' with {type: 'json'};
import print from './es/print.json' with {type: 'json'};
import samples from './es/samples.json' with {type: 'json'};
import {en, type Texts} from './en.js';

export const es: Texts = translated(
  en,
  {...page, ...pattern, ...answer, ...print, ...samples},
  'es',
);

/** Texts of the drape, which loads its own English ones. */
export {drape};
