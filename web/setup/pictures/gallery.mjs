// Makes the gallery: docs/gallery.md, and a picture of each of its garments in docs/gallery.
import {mkdirSync, readFileSync, writeFileSync} from 'node:fs';

import {root} from '../shell.mjs';
import {drapePicture, resultOf, showDrape} from './samples.mjs';

/**
 * Garments and their prints, as named in public/samples.json. The found symmetries are accepted,
 * except where the print does not allow them.
 */
const shown = [
  ['princess-dress', 'p4m'],
  ['shirt', 'check'],
  ['six-gore-skirt', 'cmm'],
  ['shift-dress', 'tartan'],
  ['raglan', 'ditsy'],
  ['trousers', 'ticking'],
  ['tee', 'cm'],
  ['asymmetric-dress', 'pmg'],
  ['gathered-skirt', 'bouquet', 'not symmetric'],
  ['patchwork-jacket', 'plaid', 'not symmetric'],
  ['hoodie', 'p6m'],
  ['apron', 'p31m', 'not symmetric'],
];

/** The dummy, in heights of the view. */
const frame = [-0.33, 0.03, 0.66, 0.88];

const introduction = `# Gallery

Twelve sample garments, each in another sample print, as the page shows them after one solve with its usual
settings. A seam matches if the print misses by at most 1 mm on average along it. *Before* is the same garment with the
pieces as drafted, on grain. [Prints](prints.md) describes the prints, and [methods](methods.md#limits) the limits: for
example, a print without mirrors cannot match on both sides of a symmetric garment.
`;

export async function gallery(open) {
  const {garments, prints} = JSON.parse(readFileSync(`${root}/public/samples.json`, 'utf8'));
  mkdirSync(`${root}/docs/gallery`, {recursive: true});
  const entries = [];
  for (const [garment, print, remark] of shown) {
    const title = `${titleOf(garments, 'style', garment)} in ${titleOf(prints, 'name', print)}`;
    const page = await open({garment, print, isSymmetric: !remark, size: [1300, 1000]});
    const text = figures(await resultOf(page));
    await showDrape(page);
    const file = `gallery/${garment}-${print}.webp`;
    writeFileSync(`${root}/docs/${file}`, await drapePicture(page, frame, 480, 0.8));
    await page.close();
    entries.push(`- ![${title}, on a dummy, from the front](${file})\n\n  **${title}.** ${text}\n`);
  }
  const list = `<div class="gallery">\n\n${entries.join('\n')}\n</div>\n`;
  writeFileSync(`${root}/docs/gallery.md`, `${introduction}\n${list}`);
}

const titleOf = (samples, key, name) => samples.find((sample) => sample[key] === name).title;

const millimetres = (cm) => `${(10 * cm).toFixed(1)} mm`;

/** The seams that match, and the mean mismatch, as sentences. */
function figures({seams, metrics}) {
  const judged = seams.filter(({matched, local}) => matched && local);
  const good = judged.filter(({local}) => local.final <= 0.1).length;
  const {drafted, final} = metrics.localCm;
  return `${good} of ${judged.length} seams match.
  On average the print misses by ${millimetres(final)}; before, by ${millimetres(drafted)}.`;
}
