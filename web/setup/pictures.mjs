// `npm run pictures`: takes the pictures of the docs from the current page: page.png, lens.png,
// before-after.svg, and the gallery with its texts. Names on the command line choose among them.
// Needs Chromium.
import {mkdtempSync, rmSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';

import {beforeAfter} from './pictures/before-after.mjs';
import {gallery} from './pictures/gallery.mjs';
import {sharp, usePage} from './pictures/samples.mjs';
import {root} from './shell.mjs';

/** Makes each picture; `open` opens a sample in the page. */
const makers = {
  page: async (open) => {
    const page = await open({garment: 'six-gore-skirt', print: 'cm'});
    await select(page, /Princess seams: Centre front/);
    await picture(page, 'page');
  },
  lens: async (open) => {
    const page = await open({garment: 'six-gore-skirt', print: 'p4m', colorScheme: 'dark'});
    await select(page, /Princess seams: Centre front/);
    await page.getByRole('button', {name: 'Enlarge', exact: true}).click();
    await page.locator('sw-lens sw-wipe-handle').locator('input').fill('35');
    await picture(page, 'lens');
  },
  'before-after': beforeAfter,
  gallery,
};

/**
 * Selects a seam by its name, and returns to the headline; the pointer does not hover over
 * anything.
 */
async function select(page, name) {
  const seams = page.getByRole('table', {name: 'Seams', exact: true});
  await seams.getByRole('row').filter({hasText: name}).first().click();
  await page.mouse.move(1250, 600);
  await page.mouse.wheel(0, -20000);
  await page.mouse.move(720, 890);
}

async function picture(page, name) {
  await sharp(page);
  await page.screenshot({path: `${root}/docs/${name}.png`});
  await page.close();
}

const wanted = process.argv.slice(2);
const unknown = wanted.find((name) => !Object.hasOwn(makers, name));
if (unknown)
  throw new Error(`no picture '${unknown}'; there are ${Object.keys(makers).join(', ')}`);
const outDir = mkdtempSync(join(tmpdir(), 'seamwise-pictures-'));
const {open, close} = await usePage(outDir);
try {
  for (const name of wanted.length > 0 ? wanted : Object.keys(makers)) await makers[name](open);
} finally {
  await close();
  rmSync(outDir, {recursive: true});
}
