import {appendFileSync, existsSync, readFileSync} from 'node:fs';

/** Counts one unit of work that has a budget in a test run, in the run's file. */
export function count(kind) {
  const file = process.env.SEAMWISE_COUNTS;
  if (file) appendFileSync(file, `${kind}\n`);
}

/** The counts of each kind of work in a file. */
export function countsIn(path) {
  const counts = {};
  const lines = existsSync(path) ? readFileSync(path, 'utf8').split('\n').filter(Boolean) : [];
  for (const kind of lines) counts[kind] = (counts[kind] ?? 0) + 1;
  return counts;
}
