import {existsSync, readdirSync, readFileSync, realpathSync, rmSync} from 'node:fs';
import {join} from 'node:path';

import {root, run, say} from './shell.mjs';

/**
 * Configures a build of CMake. One that was made in another folder, from which this one was copied or moved, is begun
 * anew: its files name that folder. One whose settings have become of no use, as when a compiler is gone that it was
 * begun with, is configured anew; what it has compiled stays, as far as the commands are the same.
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

/** Removes a build that was made from another folder than `project`. @returns whether there was one */
export function forgetMoved(folder, project) {
  const cache = join(folder, 'CMakeCache.txt');
  if (!existsSync(cache)) return false;
  const [, source = ''] =
    /^CMAKE_HOME_DIRECTORY:INTERNAL=(.*)$/m.exec(readFileSync(cache, 'utf8')) ?? [];
  if (existsSync(source) && realpathSync(source) === realpathSync(project)) return false;
  rmSync(folder, {recursive: true, force: true});
  return true;
}

/** Removes the settings and what is known of the compiler, as `cmake --fresh` would; the rest stays. */
function forgetSettings(folder) {
  rmSync(join(folder, 'CMakeCache.txt'), {force: true});
  const notes = join(folder, 'CMakeFiles');
  const ofVersions = readdirSync(notes).filter((name) => /^\d/.test(name));
  for (const name of ofVersions) rmSync(join(notes, name), {recursive: true});
}
