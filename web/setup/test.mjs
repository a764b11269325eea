// `npm test`: installs and builds what is missing, then runs every check; all of them, even when one
// fails. `npm test -- native web` runs only the checks named.
import {availableParallelism} from 'node:os';

import {build, buildPackage} from './build.mjs';
import {checkFormat, tidy} from './clang.mjs';
import {configure} from './cmake.mjs';
import {fuzz} from './fuzz.mjs';
import {ensurePackages} from './packages.mjs';
import {main, run, say, SetupError, tool} from './shell.mjs';
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
  installOtherBrowsers,
} from './system.mjs';

/** Runs a program of an npm package. */
function runTool(name, ...args) {
  const [node, program] = tool(name, name === 'typescript' ? 'tsc' : name);
  return run(node, [program, ...args]);
}

let building = null;

/** The same on the compiled package, which is what its users and its tests see. */
async function runToolOnBuild(name, ...args) {
  await (building ??= buildPackage());
  return runTool(name, ...args);
}

/** Builds one of the presets and runs the native tests in it, or those that have a label. */
async function native(preset, label) {
  await ensureSystem(forNativeTests);
  // Another compiler's new warning is no reason to fail on a user's machine.
  const strict = process.env.SEAMWISE_STRICT ? ['-DSEAMWISE_WARNINGS_ARE_ERRORS=ON'] : [];
  const built =
    (await configure(preset, strict)) &&
    (await run('cmake', ['--build', '--preset', preset, '--', '--quiet'], {output: 'on failure'}));
  const chosen = label ? ['-L', label] : [];
  const parallel = ['-j', String(availableParallelism())];
  return built && run('ctest', ['--preset', preset, ...parallel, ...chosen]);
}

/** Layout, of scripts and texts by Prettier, of C++ by clang-format. */
async function format(...flags) {
  await ensureSystem(forFormat);
  const scripts = await runTool('prettier', '--check', '--log-level=warn', ...flags, '.');
  return (await checkFormat()) && scripts;
}

/** What is suspicious: in scripts to ESLint, in C++ to clang-tidy. */
async function lint() {
  await ensureSystem(forLint);
  const scripts = await runToolOnBuild('eslint', '.', '--max-warnings=0');
  return (await configure('native')) && (await tidy('build/native')) && scripts;
}

/** Left out where there is no fuzzer, unless it was asked for by name. */
async function fuzzed(isAsked) {
  if (isAsked) await ensureSystem(forFuzzing);
  if (await hasOrInstalls(forFuzzing)) return fuzz();
  say('Left out: there is no clang with a fuzzer (in Debian clang and libclang-rt-dev).');
  return true;
}

const browserTests = ['tests/page', 'tests/examples'];

/** All that needs neither compiler nor browser. */
async function web() {
  await ensureSystem(forWebTests);
  const others = browserTests.flatMap((folder) => ['--exclude', `${folder}/**`]);
  return runToolOnBuild('vitest', 'run', ...others);
}

/** What only a browser can show; one file at a time, because they measure how pages respond. */
async function browser() {
  await ensureSystem(forBrowserTests);
  await installOtherBrowsers();
  return runToolOnBuild('vitest', 'run', ...browserTests, '--no-file-parallelism');
}

/** Of tests/web, those that take longer than all others together. */
const slowTests = ['api-reference', 'embedding-docs'];

/**
 * What two minutes can tell, for before each commit: format, types, ESLint, native tests that are labelled fast, and
 * the tests of scripts alone.
 */
async function fast() {
  await build('scripts'); // some import the package by its name
  const cache = ['--cache', '--cache-location', 'build/eslint/'];
  const others = slowTests.flatMap((name) => ['--exclude', `tests/web/${name}.test.ts`]);
  const quick = [
    () => format('--cache'),
    () => runTool('typescript', '-p', 'tsconfig.json'),
    () => runTool('eslint', '.', '--max-warnings=0', ...cache),
    () => native('native', 'fast'),
    () => runTool('vitest', 'run', 'tests/architecture.test.ts', 'tests/web', ...others),
  ];
  for (const check of quick) if (!(await check())) return false;
  return true;
}

const checks = {
  native: () => native('native'),
  sanitize: () => native('sanitize'),
  fuzz: () => fuzzed(process.argv.length > 2),
  format: () => format(),
  types: () => runToolOnBuild('typescript', '-p', 'tsconfig.json'),
  lint,
  web,
  browser,
};
/** Those that all of them hold already, and that are run by name only. */
const parts = {fast};

await main(async () => {
  const asked = process.argv.slice(2);
  const known = {...checks, ...parts};
  const unknown = asked.find((name) => !Object.hasOwn(known, name));
  if (unknown)
    throw new SetupError(`no check '${unknown}'; there are ${Object.keys(known).join(', ')}`);
  // All at once, so that whoever has to install by hand is asked only once.
  if (asked.length === 0) {
    await ensureSystem([
      ...new Set([
        ...[...forModule, ...forNativeTests, ...forFormat, ...forLint],
        ...[...forBrowserTests, ...forWebTests],
      ]),
    ]);
  }
  await ensurePackages();
  const failed = [];
  for (const name of asked.length > 0 ? asked : Object.keys(checks)) {
    say(`\n== ${name}`);
    const started = performance.now();
    let passed = false;
    try {
      passed = await known[name]();
    } catch (error) {
      if (!(error instanceof SetupError)) throw error;
      say(error.message);
    }
    const seconds = ((performance.now() - started) / 1000).toFixed(1);
    say(`== ${name} ${passed ? 'passed' : 'FAILED'} in ${seconds} s`);
    if (!passed) failed.push(name);
  }
  if (failed.length > 0) throw new SetupError(`\nfailed: ${failed.join(', ')}`);
  say('\nAll checks passed.');
});
