/** All texts of the page in German. */
import {translated} from './base/message.js';
import answer from './de/answer.json' with {type: 'json'};
import drape from './de/drape.json' with {type: 'json'};
import page from './de/page.json' with {type: 'json'};
import pattern from './de/pattern.json' with {type: 'json'};
import print from './de/print.json' with {type: 'json'};
import samples from './de/samples.json' with {type: 'json'};
import {en, type Texts} from './en.js';

export const de: Texts = translated(
  en,
  {...page, ...pattern, ...answer, ...print, ...samples},
  'de',
);

/** Texts of the drape, which loads its own English ones. */
export {drape};
