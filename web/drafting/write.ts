/** Writes public/garments: the sample garments, drafted for the sample body. */
import {mkdirSync, writeFileSync} from 'node:fs';
import {sampleBody} from './body.js';
import {draftDress} from './dress.js';
import {specification} from './panel.js';
import {draftSkirt} from './skirt.js';
import {draftTee} from './tee.js';

mkdirSync('public/garments', {recursive: true});
for (const draft of [draftTee, draftSkirt, draftDress]) {
  const garment = draft(sampleBody);
  writeFileSync(`public/garments/${garment.name}.json`, specification(garment));
}
