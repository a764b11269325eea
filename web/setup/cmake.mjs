import {existsSync, readdirSync, readFileSync, realpathSync, rmSync} from 'node:fs';
import {join} from 'node:path';

import {root, run, say} from './shell.mjs';

/**
 * Configures a build of CMake. A build copied or moved from another folder is started over, as its
 * files name that folder. A build with invalid settings, for example of a compiler that no longer
 * exists, is configured again. Compiled files with unchanged commands remain.
 * @returns whether it succeeded
 */
export async function configure(preset, flags = [], project = root) {
  const folder = join(project, 'build', preset);
  if (forgetMoved(folder, project)) {
    say(`build/${preset} was made in another folder, and is made anew ...`);
  }
  const words = ['-S', project, '--preset', preset, ...flags];
  if (existsSync(join(folder, 'CMakeCache.txt'))) {
    if (await run('cmake', words, {output: 'never'})) return true;
    forgetSettings(folder);
  }
  return run('cmake', words, {output: 'on failure'});
}

/** Removes a build made from another folder than `project`. @returns whether there was one */
export function forgetMoved(folder, project) {
  const cache = join(folder, 'CMakeCache.txt');
  if (!existsSync(cache)) return false;
  const [, source = ''] =
    /^CMAKE_HOME_DIRECTORY:INTERNAL=(.*)$/m.exec(readFileSync(cache, 'utf8')) ?? [];
  if (existsSync(source) && realpathSync(source) === realpathSync(project)) return false;
  rmSync(folder, {recursive: true, force: true});
  return true;
}

/** Removes the settings and the data about the compiler, like `cmake --fresh`; the rest stays. */
function forgetSettings(folder) {
  rmSync(join(folder, 'CMakeCache.txt'), {force: true});
  const notes = join(folder, 'CMakeFiles');
  const ofVersions = readdirSync(notes).filter((name) => /^\d/.test(name));
  for (const name of ofVersions) rmSync(join(notes, name), {recursive: true});
}
