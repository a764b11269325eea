/** Writes public/prints: one print file and one tile for each wallpaper group. */
import {mkdirSync, writeFileSync} from 'node:fs';
import {designs} from './prints.js';
import {printFile, tile} from './tile.js';

mkdirSync('public/prints', {recursive: true});
for (const design of designs) {
  const path = `public/prints/${design.print.group}`;
  writeFileSync(`${path}.json`, printFile(design));
  writeFileSync(`${path}.svg`, tile(design));
}
