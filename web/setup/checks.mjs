import {availableParallelism} from 'node:os';

import {build, moduleProducts} from './build.mjs';
import {checkFormat, clangTool, tidy} from './clang.mjs';
import {configure} from './cmake.mjs';
import {forProblems, forSeconds, fuzz} from './fuzz.mjs';
import {projectFiles, unlessPassed} from './passed.mjs';
import {timesOf} from './report.mjs';
import {run, say, tool} from './shell.mjs';
import {
  ensureSystem,
  forBrowserTests,
  forFormat,
  forFuzzing,
  forLint,
  forModule,
  forNativeTests,
  forWebTests,
  hasOrInstalls,
  installHeadlessShell,
  installOtherBrowsers,
} from './system.mjs';

/** Runs a program of an npm package. */
function runTool(name, ...args) {
  const [node, program] = tool(name, name === 'typescript' ? 'tsc' : name);
  return run(node, [program, ...args]);
}

/** Builds a preset and runs its native tests. @param which  arguments of ctest that choose tests */
async function native(preset, {isAnew, level}, flags = [], which = []) {
  await ensureSystem(forNativeTests);
  // A new warning of another compiler should not fail on a user's machine.
  const strict = process.env.SEAMWISE_STRICT ? ['-DSEAMWISE_WARNINGS_ARE_ERRORS=ON'] : [];
  const built =
    (await configure(preset, [...strict, ...flags])) &&
    (await run('cmake', ['--build', '--preset', preset, '--', '--quiet'], {output: 'on failure'}));
  if (!built) return false;
  const parallel = ['-j', String(availableParallelism())];
  const times = ['--output-junit', timesOf(`${preset}.xml`)];
  const words = ['--preset', preset, ...parallel, ...times, ...which];
  const programs = [`build/${preset}/tests/native/seamwise_tests`, ...nativeTestFiles];
  return unlessPassed([preset, ...which].join(' '), programs, isAnew, () =>
    run('ctest', words, {env: {SEAMWISE_TESTS: level}}),
  );
}

/** Files that native tests read. */
const nativeTestFiles = ['tests/fixtures', 'public/garments', 'web/src/model/base/core-tables.ts'];

/** One build for tests and fuzzer, by clang; by another compiler if clang is unavailable. */
async function sanitize(level, ...which) {
  const canFuzz = await hasOrInstalls(forFuzzing);
  const clang = [`-DCMAKE_CXX_COMPILER=${clangTool('clang++')}`, '-DSEAMWISE_FUZZ=ON'];
  return native('sanitize', level, canFuzz ? clang : [], which);
}

/** Runs the fuzzer; skipped if it is unavailable. */
async function fuzzed({isThorough, isAnew}) {
  if (await hasOrInstalls(forFuzzing)) {
    if (isThorough) return fuzz(forSeconds(60));
    const read = ['build/sanitize/tests/fuzz/problem_fuzz', 'public', 'web/setup/fuzz.mjs'];
    return unlessPassed('fuzz', read, isAnew, () => fuzz(forProblems(2000)));
  }
  say('Left out: there is no clang with a fuzzer (in Debian clang and libclang-rt-dev).');
  return true;
}

/** Checks the format of scripts and texts by Prettier, and of C++ by clang-format. */
async function format({isThorough}) {
  await ensureSystem(forFormat);
  const cache = ['--cache', '--cache-strategy=content', '--cache-location=build/prettier.json'];
  const flags = ['--check', '--log-level=warn', ...(isThorough ? [] : cache)];
  const scripts = await runTool('prettier', ...flags, '.');
  return (await checkFormat()) && scripts;
}

const types = () =>
  runTool(
    'typescript',
    ...['-p', 'tsconfig.json', '--incremental', '--tsBuildInfoFile', 'build/types.tsbuildinfo'],
  );

/** Runs ESLint on files changed since it passed, or on all in the thorough run. */
function eslint({isThorough}) {
  const cache = ['--cache', '--cache-strategy', 'content', '--cache-location', 'build/eslint/'];
  return runTool('eslint', '.', '--max-warnings=0', ...(isThorough ? [] : cache));
}

async function clangTidy({isThorough}) {
  await ensureSystem(forLint);
  return tidy('build/sanitize', isThorough);
}

/**
 * Runs a project of vitest.config.ts.
 * @param read  files that decide the outcome; undefined if unknown
 * @param more  arguments
 */
function vitest(name, {isThorough, isAnew, level}, read, ...more) {
  const levels = isThorough ? [] : ['--tags-filter=!thorough'];
  const times = [
    '--reporter=default',
    '--reporter=json',
    `--outputFile=${timesOf(`${name}.json`)}`,
  ];
  const [node, program] = tool('vitest');
  const words = [program, 'run', `--project=${name}`, ...levels, ...times, ...more];
  const tests = [name, ...more.filter((word) => !word.startsWith('-'))].join(' ');
  return unlessPassed(tests, read ?? [], isAnew || !read, () =>
    run(node, words, {env: {SEAMWISE_TESTS: level}}),
  );
}

/** Runs the tests that need neither compiler nor browser. */
async function web(level, ...files) {
  await ensureSystem(forWebTests);
  const read = projectFiles();
  const workers = `--maxWorkers=${availableParallelism()}`;
  return vitest('web', level, read && [...read, ...moduleProducts], workers, ...files);
}

/**
 * Runs the tests that need a browser. A page waits for frames and timers, so there is one file more
 * than cores.
 */
async function browser(level) {
  await installHeadlessShell();
  await ensureSystem(forBrowserTests);
  if (level.isThorough) await installOtherBrowsers();
  const read = projectFiles('docs', 'wasm', 'tests/native');
  const workers = `--maxWorkers=${availableParallelism() + 1}`;
  return vitest('browser', level, read && [...read, ...moduleProducts], workers);
}

/** Runs the time measurements, for which nothing else runs at the same time. */
async function timing(level) {
  await ensureSystem(forBrowserTests);
  return vitest('timing', level, undefined);
}

async function product() {
  await ensureSystem(forModule);
  await build('tarball', 'page', 'fixtures');
  return true;
}

/**
 * Checks by name, in the order of their start; `needs` are the checks whose products they need, and
 * `after` those for which they wait only if these run as well.
 */
export const checks = {
  build: {run: product},
  sanitize: {run: (level) => sanitize(level)},
  browser: {needs: ['build'], run: browser},
  native: {run: (level) => native('native', level)},
  web: {needs: ['build'], after: ['native'], run: (level) => web(level)},
  fuzz: {needs: ['sanitize'], run: fuzzed},
  tidy: {needs: ['sanitize'], run: clangTidy},
  eslint: {needs: ['build'], run: eslint},
  types: {needs: ['build'], run: types},
  format: {run: format},
  timing: {needs: ['build'], isAlone: true, run: timing},
};

/** Checks of the thorough run. */
export const thorough = Object.keys(checks);
/** Checks of a commit; sanitizers find more in native tests than their optimised build. */
export const ordinary = thorough.filter((name) => name !== 'timing' && name !== 'native');
/** Checks while working: below two minutes once all is built. */
export const fast = ['build', 'brief', 'eslint', 'types', 'format', 'scripts'];
/** Native tests that solve and simulate little. */
checks.brief = {run: (level) => sanitize(level, '-LE', 'slow')};
/** Tests of scripts that start no program and solve nothing. */
checks.scripts = {
  needs: ['build'],
  run: (level) => web(level, 'tests/rules', 'tests/web'),
};

export const systemNeeds = [
  ...new Set([
    ...[...forModule, ...forNativeTests, ...forFormat, ...forLint],
    ...[...forBrowserTests, ...forWebTests],
  ]),
];
