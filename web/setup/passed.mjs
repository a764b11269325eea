import {spawnSync} from 'node:child_process';
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

/**
 * The project's files that git tracks or would track, outside of some folders; undefined if it is
 * in no repository.
 */
export function projectFiles(...without) {
  const words = ['ls-files', '--cached', '--others', '--exclude-standard', '-z'];
  const {status, stdout} = spawnSync('git', words, {cwd: root, encoding: 'utf8'});
  if (status !== 0) return undefined;
  const paths = stdout.split('\0');
  if (!paths.includes('package.json')) return undefined; // ignored by a repository around it
  const isWithin = (path) => !without.some((folder) => path.startsWith(`${folder}/`));
  return paths.filter((path) => path !== '' && isWithin(path));
}

/** Identifies the contents of files and folders, and the version of Node. */
function contentsOf(paths) {
  const hash = createHash('sha256').update(process.version);
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
