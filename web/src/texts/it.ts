/** All texts of the page in Italian. */
import {translated} from './base/message.js';
import answer from './it/answer.json' with {type: 'json'};
import drape from './it/drape.json' with {type: 'json'};
import page from './it/page.json' with {type: 'json'};
import pattern from './it/pattern.json' with {type: 'json'};
import print from './it/print.json' with {type: 'json'};
import samples from './it/samples.json' with {type: 'json'};
import {en, type Texts} from './en.js';

export const it: Texts = translated(
  en,
  {...page, ...pattern, ...answer, ...print, ...samples},
  'it',
);

/** Texts of the drape, which loads its own English ones. */
export {drape};
