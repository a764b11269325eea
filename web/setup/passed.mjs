import {createHash} from 'node:crypto';
import {
  existsSync,
  mkdirSync,
  readdirSync,
  readFileSync,
  rmSync,
  statSync,
  writeFileSync,
} from 'node:fs';
import {join} from 'node:path';

import {root, say} from './shell.mjs';

/**
 * Runs deterministic tests, or says that it leaves them out, since they passed with the same program
 * and files.
 * @param name of the tests
 * @param read  programs, files and folders that decide the outcome
 * @param isAnew whether to run them in any case
 * @param work  runs them, and returns whether they passed
 */
export async function unlessPassed(name, read, isAnew, work) {
  const folder = join(root, 'build/passed');
  const stamp = join(folder, name.replaceAll(/\W+/g, '-'));
  const state = contentsOf(read);
  if (!isAnew && existsSync(stamp) && readFileSync(stamp, 'utf8') === state) {
    say('Left out: these tests passed, and neither program nor files have changed since.');
    return true;
  }
  rmSync(stamp, {force: true});
  const passed = await work();
  mkdirSync(folder, {recursive: true});
  if (passed) writeFileSync(stamp, state);
  return passed;
}

/** Identifies the contents of files and folders. */
function contentsOf(paths) {
  const hash = createHash('sha256');
  for (const path of paths.flatMap(filesIn))
    hash.update(path).update(readFileSync(join(root, path)));
  return hash.digest('hex');
}

/** The files below a path; none for a program that could not be built. */
function filesIn(path) {
  if (!existsSync(join(root, path))) return [];
  if (!statSync(join(root, path)).isDirectory()) return [path];
  return readdirSync(join(root, path))
    .sort()
    .flatMap((name) => filesIn(join(path, name)));
}
