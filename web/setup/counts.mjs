import {appendFileSync, existsSync, readFileSync} from 'node:fs';

/** Counts one piece of work that a test run has a budget for, in the file that the run names. */
export function count(kind) {
  const file = process.env.SEAMWISE_COUNTS;
  if (file) appendFileSync(file, `${kind}\n`);
}

/** The number of pieces of work of each kind that are counted in a file. */
export function countsIn(path) {
  const counts = {};
  const lines = existsSync(path) ? readFileSync(path, 'utf8').split('\n').filter(Boolean) : [];
  for (const kind of lines) counts[kind] = (counts[kind] ?? 0) + 1;
  return counts;
}
