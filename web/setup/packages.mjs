import {statSync} from 'node:fs';
import {join} from 'node:path';

import {must, root, run, say} from './shell.mjs';

const changed = (file) => statSync(join(root, file), {throwIfNoEntry: false})?.mtimeMs ?? 0;

/** Installs the npm packages if they are missing or older than the lock file. */
export async function ensurePackages() {
  if (changed('node_modules/.package-lock.json') >= changed('package-lock.json')) return;
  say('Installing npm packages ...');
  const flags = ['--include=dev', '--no-audit', '--no-fund', '--loglevel=error'];
  if (await run('npm', ['ci', ...flags], {output: 'never'})) return;
  await must('npm', ['install', ...flags]);
}
