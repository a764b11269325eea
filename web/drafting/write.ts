/** Writes public/garments: every garment of the wardrobe in every size. */
import {mkdirSync, rmSync, writeFileSync} from 'node:fs';
import {bodyOf, sizeNames} from './body.js';
import {garmentFile} from './garment-file.js';
import {wardrobe} from './wardrobe.js';

const folder = 'public/garments';
rmSync(folder, {recursive: true, force: true});
mkdirSync(folder, {recursive: true});
for (const draft of wardrobe) {
  for (const size of sizeNames) {
    const garment = draft(bodyOf(size));
    writeFileSync(`${folder}/${garment.name}-${size}.json`, garmentFile(garment, size));
  }
}
