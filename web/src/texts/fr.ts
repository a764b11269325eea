/** All texts of the page in French. */
import {translated} from './base/message.js';
import answer from './fr/answer.json' with {type: 'json'};
import drape from './fr/drape.json' with {type: 'json'};
import page from './fr/page.json' with {type: 'json'};
import pattern from './fr/pattern.json' with {type: 'json'};
import print from './fr/print.json' with {type: 'json'};
import samples from './fr/samples.json' with {type: 'json'};
import {en, type Texts} from './en.js';

export const fr: Texts = translated(
  en,
  {...page, ...pattern, ...answer, ...print, ...samples},
  'fr',
);

/** Texts of the drape, which loads its own English ones. */
export {drape};
