/** Writes public/prints: every print's file, and its tiles as SVG and PNG. */
import {mkdirSync, writeFileSync} from 'node:fs';

import {collection} from './collection.js';
import {palettes} from './palette.js';
import {indexedPng} from './png.js';
import {printFile, tilesOf} from './print-files.js';
import {rendered} from './raster.js';

const folder = 'public/prints';
mkdirSync(folder, {recursive: true});
for (const design of collection) {
  writeFileSync(`${folder}/${design.id}.json`, printFile(design));
  for (const {name, palette, svg, pixels} of tilesOf(design)) {
    writeFileSync(`${folder}/${name}.svg`, svg);
    const png = indexedPng(await rendered(svg, ...pixels), Object.values(palettes[palette]));
    writeFileSync(`${folder}/${name}.png`, png);
  }
}
