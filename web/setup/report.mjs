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

/** Test files with their seconds and their failures, each a test and what it said. */
function vitestFiles(path) {
  const {testResults} = JSON.parse(readFileSync(path, 'utf8'));
  return testResults.map(({name, startTime, endTime, status, message, assertionResults}) => {
    const failures = assertionResults
      .filter((result) => result.status === 'failed')
      .map(({fullName, failureMessages}) => ({test: fullName, said: failureMessages.join('\n')}));
    const isBroken = status === 'failed' && failures.length === 0;
    return {
      name: relative(root, name),
      seconds: (endTime - startTime) / 1000,
      failures: isBroken ? [{test: 'the file itself', said: message}] : failures,
    };
  });
}

function ctestFiles(path, preset) {
  const cases = readFileSync(path, 'utf8').matchAll(
    /<testcase name="([\w/]+)".*? time="([\d.]+)" status="(\w+)"[^]*?<\/testcase>/g,
  );
  return [...cases].map(([text, name, time, status]) => {
    const [, said = ''] = /<system-out>([^]*?)<\/system-out>/.exec(text) ?? [];
    return {
      name: `tests/native/${name}.cpp (${preset})`,
      seconds: Number(time),
      failures: status === 'fail' ? [{test: name, said: said.trim().slice(-4000)}] : [],
    };
  });
}

/** Prints each failed test with what it said: at the end, where a long output is read. */
function reportFailures(files) {
  for (const {name, failures} of files) {
    for (const {test, said} of failures) {
      const lines = said.split('\n').slice(0, 40);
      say(`\nFAILED ${name}\n  ${test}\n${lines.map((line) => `    ${line}`).join('\n')}`);
    }
  }
}

/**
 * Prints the seconds of each check, the ten slowest test files, the counted work, and the failures.
 */
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
  reportFailures(files);
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
