import {copyFileSync, existsSync, mkdirSync, readFileSync} from 'node:fs';
import {dirname, join, posix} from 'node:path';

import {root} from './shell.mjs';

/**
 * Copies the declarations reachable from the package's entries from `folder` to dist; the rest
 * would be useless weight.
 */
export function copyDeclarations(folder) {
  const {exports} = JSON.parse(readFileSync(join(root, 'package.json'), 'utf8'));
  const copied = new Set();
  const follow = (file) => {
    const source = [folder, 'web/src']
      .map((place) => join(root, place, file))
      .find((path) => existsSync(path));
    if (copied.has(file) || source === undefined) return; // the module's declaration already exists
    copied.add(file);
    const target = join(root, 'dist', file);
    mkdirSync(dirname(target), {recursive: true});
    copyFileSync(source, target);
    const imports = readFileSync(source, 'utf8').matchAll(
      /\b(?:from|import)\s*\(?\s*["'](\.[^"']+)\.js["']/g,
    );
    for (const [, name] of imports) follow(posix.join(posix.dirname(file), `${name}.d.ts`));
  };
  for (const {types} of Object.values(exports)) {
    if (types) follow(posix.relative('dist', types));
  }
}
