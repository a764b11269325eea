/** Writes public/garments: every garment of the wardrobe in every size; and public/samples.json. */
import {mkdirSync, rmSync, writeFileSync} from 'node:fs';
import {bodyOf, sizeNames} from './body.js';
import {garmentFile} from './garment-file.js';
import {sampleList} from './sample-list.js';
import {wardrobe} from './wardrobe.js';

const folder = 'public/garments';
// drafts all before writing the first, so that a failing draft leaves the folder unchanged
const files = wardrobe.flatMap((draft) =>
  sizeNames.map((size) => {
    const garment = draft(bodyOf(size));
    return [`${garment.name}-${size}.json`, garmentFile(garment, size)] as const;
  }),
);
rmSync(folder, {recursive: true, force: true});
mkdirSync(folder, {recursive: true});
for (const [name, text] of files) writeFileSync(`${folder}/${name}`, text);
writeFileSync('public/samples.json', sampleList());
