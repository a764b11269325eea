import {existsSync, mkdirSync, readFileSync, rmSync} from 'node:fs';
import {join, relative} from 'node:path';

import {root, say} from './shell.mjs';

/** Folder of the runners' reports of the seconds that test files took. */
const folder = join(root, 'build/report');

/** File for a runner's times: JSON of Vitest, or JUnit's XML of CTest. */
export const timesOf = (name) => join(folder, name);

export function beginReport() {
  rmSync(folder, {recursive: true, force: true});
  mkdirSync(folder, {recursive: true});
}

/** Test files with their seconds. */
function vitestFiles(path) {
  const {testResults} = JSON.parse(readFileSync(path, 'utf8'));
  return testResults.map(({name, startTime, endTime}) => ({
    name: relative(root, name),
    seconds: (endTime - startTime) / 1000,
  }));
}

function ctestFiles(path, preset) {
  const cases = readFileSync(path, 'utf8').matchAll(/<testcase name="(\w+)".*? time="([\d.]+)"/g);
  return [...cases].map(([, name, time]) => ({
    name: `tests/native/${name}.cpp (${preset})`,
    seconds: Number(time),
  }));
}

/** Prints the seconds of each check, the ten slowest test files, and the counted work. */
export function report(checks, counts, budgets) {
  const rows = checks.map(({name, passed, seconds}) => [
    name,
    `${seconds.toFixed(1)} s`,
    passed ? '' : 'FAILED',
  ]);
  say(`\nChecks, two at a time:\n${table(rows)}`);
  const files = [
    ...['web', 'browser', 'timing'].flatMap((name) => read(name, 'json', vitestFiles)),
    ...['native', 'sanitize'].flatMap((name) => read(name, 'xml', ctestFiles)),
  ];
  const slowest = files.sort((a, b) => b.seconds - a.seconds).slice(0, 10);
  if (slowest.length > 0) {
    const list = slowest.map(({name, seconds}) => [name, `${seconds.toFixed(1)} s`]);
    say(`\nSlowest files:\n${table(list)}`);
  }
  const work = Object.entries(budgets).map(([kind, most]) => [
    kind,
    `${counts[kind] ?? 0} of ${most}`,
  ]);
  if (Object.keys(counts).length > 0) say(`\nWork:\n${table(work)}`);
}

function read(name, ending, files) {
  const path = timesOf(`${name}.${ending}`);
  return existsSync(path) ? files(path, name) : [];
}

function table(rows) {
  const widths = rows[0].map((_, k) => Math.max(...rows.map((row) => row[k].length)));
  return rows
    .map((row) => `  ${row.map((cell, k) => cell.padEnd(widths[k])).join('  ')}`.trimEnd())
    .join('\n');
}
