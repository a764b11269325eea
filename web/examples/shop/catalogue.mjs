// The catalogue: four of the sample garments in five sizes, and eight of the sample prints. The
// server reads only these files, regardless of the URLs in a design.
import {readFile} from 'node:fs/promises';
import {join} from 'node:path';

import {sha256Of} from 'seamwise/node';

export const sizes = ['xs', 's', 'm', 'l', 'xl'];

export const garments = [
  {
    name: 'tee',
    title: 'Tee',
    print: 'p4m',
    line: 'Two sleeves, a front and a back. The first thing to sew, and the one to wear most.',
  },
  {
    name: 'shift-dress',
    title: 'Shift dress',
    print: 'p6m',
    line: 'Straight, with bust darts and short sleeves, so that the print can speak.',
  },
  {
    name: 'six-gore-skirt',
    title: 'Six-gore skirt',
    print: 'cmm',
    line: 'Six panels that flare to the hem, and a print that does not know it was ever cut.',
  },
  {
    name: 'raglan',
    title: 'Raglan shirt',
    print: 'ditsy',
    line: 'Sleeves up to the neck: one long seam across each shoulder, and the print across both.',
  },
];

const printNames = ['p4m', 'p6m', 'cmm', 'ditsy', 'bouquet', 'p4g', 'tartan', 'check'];

/** @param folder  with `garments` and `prints`, such as the samples of the package's repository */
export async function openCatalogue(folder) {
  const files = new Map();
  const add = async (path) => {
    const bytes = await readFile(join(folder, path));
    files.set(`/${path}`, {bytes, sha256: sha256Of(bytes)});
    return bytes.toString();
  };
  /** The names of a garment's pieces, by its path. */
  const pieces = new Map();
  for (const {name} of garments) {
    for (const size of sizes) {
      const {pattern} = JSON.parse(await add(`garments/${name}-${size}.json`));
      pieces.set(garmentPath(name, size), new Set(Object.keys(pattern.panels)));
    }
  }
  const prints = [];
  for (const name of printNames) {
    const file = JSON.parse(await add(`prints/${name}.json`));
    for (const {image, raster} of file.colourways) {
      await add(`prints/${image}`);
      await add(`prints/${raster}`);
    }
    prints.push({name, ...file});
  }
  await add('icon.svg');
  return {garments, prints, files, pieces};
}

export const garmentPath = (name, size) => `/garments/${name}-${size}.json`;
export const printPath = (name) => `/prints/${name}.json`;
