// Garments and prints for `npm run bench`.
import {existsSync, readdirSync, readFileSync} from 'node:fs';
import {basename, join, resolve} from 'node:path';

import {root, SetupError} from '../../web/setup/shell.mjs';

/**
 * Finds the sample garments and every sewing pattern below the given folders.
 * @param folders  further folders of garments, relative to the caller's current directory
 * @param only  part of the name that the garments must have
 * @throws {SetupError} when a folder does not exist, or no garment is left
 */
export function findGarments(folders, only = '') {
  for (const folder of folders) {
    if (!existsSync(folder)) throw new SetupError(`there is no folder '${folder}'`);
  }
  const samples = jsonBelow(join(root, 'public/garments')).filter(isMiddleSize);
  const others = folders.map((folder) => resolve(folder)).flatMap(jsonBelow);
  const files = [...samples, ...others].filter((file) => isGarment(file));
  const garments = files
    .map((file) => ({file, name: nameOf(file, files)}))
    .filter(({name}) => name.includes(only));
  if (garments.length === 0) throw new SetupError(`there is no garment '${only}'`);
  return garments;
}

const jsonBelow = (folder) =>
  readdirSync(folder, {recursive: true})
    .filter((name) => name.endsWith('.json'))
    .sort()
    .map((name) => join(folder, name));

/** One size represents all: sizes differ by a few centimetres only. */
const isMiddleSize = (file) => file.endsWith('-m.json');

function isGarment(file) {
  try {
    return typeof JSON.parse(readFileSync(file, 'utf8')).pattern?.panels === 'object';
  } catch {
    return false;
  }
}

const short = (file) => basename(file, '.json').replace(/_specification$/, '');

/** Returns the name of the file, with its folder where two files have the same name. */
function nameOf(file, files) {
  const name = short(file);
  const isUnique = files.filter((other) => short(other) === name).length === 1;
  return isUnique ? name : `${basename(join(file, '..'))}/${name}`;
}

/** Finds the sample prints of the groups. @throws {SetupError} for a group without one */
export function findPrints(groups) {
  return groups.map((group) => {
    const file = join(root, `public/prints/${group}.json`);
    if (!existsSync(file)) throw new SetupError(`there is no print of group '${group}'`);
    return {group, file};
  });
}
