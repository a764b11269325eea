import {existsSync, readFileSync, realpathSync, rmSync} from 'node:fs';
import {join} from 'node:path';

import {root, run, say} from './shell.mjs';

/**
 * Configures a build of CMake. One that was made in another folder, from which this one was copied or moved, is begun
 * anew: its files name that folder.
 * @returns whether it succeeded
 */
export function configure(preset, flags = []) {
  if (forgetMoved(join(root, 'build', preset), root)) {
    say(`build/${preset} was made in another folder, and is made anew ...`);
  }
  return run('cmake', ['--preset', preset, ...flags], {output: 'on failure'});
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
