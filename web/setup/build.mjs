import {createHash} from 'node:crypto';
import {
  copyFileSync,
  existsSync,
  mkdirSync,
  readdirSync,
  readFileSync,
  renameSync,
  rmSync,
  statSync,
  writeFileSync,
} from 'node:fs';
import {dirname, join, relative} from 'node:path';
import {setTimeout as sleep} from 'node:timers/promises';
import {pathToFileURL} from 'node:url';

import {configure} from './cmake.mjs';
import {count} from './counts.mjs';
import {copyDeclarations} from './declarations.mjs';
import {copyNotices} from './notices.mjs';
import {ensurePackages} from './packages.mjs';
import {main, must, root, say, SetupError, tool} from './shell.mjs';
import {ensureSystem, forModule, forNativeTests} from './system.mjs';
import {scriptTranslations} from './translations.mjs';

const at = (...parts) => join(root, ...parts);
const moduleFolder = 'web/src/solver/module';
/** Files of the WebAssembly modules. Drape, marker and photo are fetched on demand. */
const moduleFiles = ['seamwise', 'drape', 'marker', 'photo'].flatMap((name) => [
  `${name}.mjs`,
  `${name}.wasm`,
]);
/** The modules as compiled. */
export const moduleProducts = moduleFiles.map((file) => `${moduleFolder}/${file}`);
const declarations = 'build/declarations';
/** Sources of the modules. */
export const moduleSources = ['CMakeLists.txt', 'CMakePresets.json', 'wasm'];

/** The package as written by `npm pack`. */
export const tarball = at('build/package/seamwise.tgz');

/**
 * The parts of a build: each is made from the part in `after`, and from the files in `from` and the
 * environment variable `variable`.
 */
const parts = {
  module: {
    from: moduleSources,
    make: buildModule,
    products: moduleProducts,
  },
  scripts: {
    after: 'module',
    from: ['package.json', 'tsconfig.json', 'tsconfig.build.json', 'web/src'],
    make: buildScripts,
    products: ['dist/cli/main.js', ...moduleFiles.map((file) => `dist/solver/module/${file}`)],
  },
  standalone: {
    after: 'scripts',
    from: ['vite.standalone.config.ts', 'package-lock.json', 'LICENSE', 'web/setup/notices'],
    make: buildStandalone,
    products: ['seamwise.js', 'seamwise.wasm', 'drape.wasm', 'marker.wasm', 'photo.wasm'].map(
      (file) => `dist/standalone/${file}`,
    ),
  },
  tarball: {
    after: 'standalone',
    from: ['CHANGELOG.md', 'CONTRIBUTING.md', 'README.md', 'docs', 'public', 'web/examples'],
    make: pack,
    products: [relative(root, tarball)],
  },
  page: {
    after: 'scripts',
    from: ['vite.config.ts', 'package-lock.json', 'public', 'web/index.html', 'web/setup/notices'],
    make: buildPage,
    products: ['build/page/index.html', 'build/page/service-worker.js'],
  },
  // not built for `npm start` and `npm test`
  site: {
    after: 'standalone',
    from: [
      'CHANGELOG.md',
      'CONTRIBUTING.md',
      'docs',
      'package-lock.json',
      'public',
      'web/examples',
    ],
    variable: 'SITE_BASE',
    make: buildSite,
    products: ['build/site/index.html', 'build/site/seamwise/seamwise.js'],
  },
  // test pages that import sources of the project
  fixtures: {
    after: 'scripts',
    from: ['package-lock.json', 'tests/support/pages/element', 'tests/support/pages/solver'],
    make: buildFixtures,
    products: ['element', 'solver'].map((name) => `build/fixtures/${name}/index.html`),
  },
};

/** Builds the missing or outdated parts, and the parts they are made from. */
export async function build(...wanted) {
  const states = [...new Set(wanted.flatMap(chain))].map((part) => [part, stateOf(part)]);
  if (states.every(([part, state]) => isFresh(part, state))) return;
  const unlock = await lock();
  try {
    for (const [part, state] of states) {
      if (isFresh(part, state)) continue;
      await parts[part].make();
      stamp(part, state);
    }
  } finally {
    unlock();
  }
}

/** Builds the parts named on the command line, or the package and the documentation site. */
async function buildNamed() {
  const named = process.argv.slice(2);
  const unknown = named.find((name) => !Object.hasOwn(parts, name));
  if (unknown) {
    throw new SetupError(`no part '${unknown}'; there are ${Object.keys(parts).join(', ')}`);
  }
  await build(...(named.length > 0 ? named : ['standalone', 'site']));
}

/** A part, preceded by all that it is made from. */
function chain(part) {
  const {after} = parts[part];
  return after ? [...chain(after), part] : [part];
}

/** Identifies the state of the files that a part is made from. */
function stateOf(part) {
  const {after, from, variable} = parts[part];
  const given = variable ? [process.env[variable]] : [];
  return signature(from, after ? stateOf(after) : '', ...given);
}

async function buildModule() {
  await ensureSystem(forModule);
  say('Building the solver; the first time takes a minute or two ...');
  await mustConfigure('wasm');
  await must('cmake', ['--build', '--preset', 'wasm', '--', '--quiet']);
  for (const file of moduleFiles) {
    copyFileSync(at('build/wasm', file), at(moduleFolder, file));
  }
}

async function mustConfigure(preset) {
  if (!(await configure(preset))) throw new SetupError(`failed: cmake --preset ${preset}`);
}

/**
 * Builds the program of `npm run bench`, 'native' or, for Node, 'wasm'. @returns the command line
 * of each
 */
export async function buildBench(platforms) {
  await ensureSystem([...new Set([...forModule, ...forNativeTests])]);
  say('Building the benchmark; the first time takes some minutes ...');
  const unlock = await lock();
  try {
    for (const preset of platforms) {
      await mustConfigure(preset);
      const target = ['--target', 'seamwise_bench', '--', '--quiet'];
      await must('cmake', ['--build', '--preset', preset, ...target]);
    }
  } finally {
    unlock();
  }
  return {
    native: [at('build/native/tests/bench/seamwise_bench')],
    wasm: [process.execPath, at('build/wasm/tests/bench/seamwise_bench.cjs')],
  };
}

async function buildScripts() {
  await ensurePackages();
  say('Compiling TypeScript ...');
  rmSync(at('dist'), {recursive: true, force: true});
  const [node, tsc] = tool('typescript', 'tsc');
  const compile = [tsc, '-p', 'tsconfig.build.json'];
  // Scripts are downloaded and need no comments; declarations keep them for editors, and maps keep
  // the sources.
  const maps = ['--sourceMap', '--inlineSources'];
  await must(node, [
    ...compile,
    '--declaration',
    'false',
    '--noCheck',
    '--removeComments',
    ...maps,
  ]);
  scriptTranslations(at('dist/texts'));
  rmSync(at(declarations), {recursive: true, force: true});
  await must(node, [...compile, '--emitDeclarationOnly', '--outDir', declarations]);
  copyDeclarations(declarations);
  mkdirSync(at('dist/solver/module'), {recursive: true});
  for (const file of moduleFiles) {
    copyFileSync(at(moduleFolder, file), at('dist/solver/module', file));
  }
}

async function buildStandalone() {
  say('Building the element as one script ...');
  const [node, vite] = tool('vite');
  const build = [vite, 'build', '-c', 'vite.standalone.config.ts', '--logLevel', 'warn'];
  // Tests set another NODE_ENV, which would select Lit's build for developers.
  await must(node, build, {env: {NODE_ENV: 'production'}});
  copyNotices();
}

/** Packs the package. Its parts are up to date, so npm's own call of the build is skipped. */
async function pack() {
  say('Packing ...');
  const folder = dirname(tarball);
  rmSync(folder, {recursive: true, force: true});
  mkdirSync(folder, {recursive: true});
  await must('npm', ['pack', '--ignore-scripts', '--loglevel=error', '--pack-destination', folder]);
  const [name] = readdirSync(folder);
  renameSync(join(folder, name), tarball);
}

async function buildPage() {
  count('page build');
  say('Building the page ...');
  const [node, vite] = tool('vite');
  await must(node, [vite, 'build', '--logLevel', 'warn'], {env: {NODE_ENV: 'production'}});
}

async function buildSite() {
  say('Building the documentation site ...');
  const [node, vitepress] = tool('vitepress');
  await must(node, [vitepress, 'build', 'docs'], {env: {NODE_ENV: 'production'}});
}

async function buildFixtures() {
  say('Building the pages of tests ...');
  const [node, vite] = tool('vite');
  for (const name of ['element', 'solver']) {
    const folders = [at('tests/support/pages', name), '--outDir', at('build/fixtures', name)];
    const config = ['-c', at('tests/support/pages/vite.config.ts'), '--logLevel', 'warn'];
    const build = [vite, 'build', ...folders, ...config];
    count('page build');
    await must(node, build, {env: {NODE_ENV: 'production'}});
  }
}

/** Hash of the state of files and folders: names, sizes and modification times. */
function signature(paths, ...more) {
  const hash = createHash('sha256');
  const visit = (path) => {
    if (parts.module.products.includes(path)) return;
    const state = statSync(at(path));
    if (state.isDirectory()) {
      for (const name of readdirSync(at(path)).sort()) visit(`${path}/${name}`);
    } else {
      hash.update(`${path} ${state.size} ${state.mtimeMs}\n`);
    }
  };
  paths.forEach(visit);
  return hash.update(more.join()).digest('hex');
}

function isFresh(part, state) {
  const file = at('build', `${part}.stamp`);
  return (
    [...parts[part].products.map((path) => at(path)), file].every((path) => existsSync(path)) &&
    readFileSync(file, 'utf8') === state
  );
}

function stamp(part, state) {
  writeFileSync(at('build', `${part}.stamp`), state);
}

/** Prevents two simultaneous builds in one folder. @returns a function that unlocks */
async function lock() {
  const file = at('build/lock');
  mkdirSync(at('build'), {recursive: true});
  for (let waited = false; ; waited = true) {
    try {
      writeFileSync(file, String(process.pid), {flag: 'wx'});
      return () => rmSync(file, {force: true});
    } catch (error) {
      if (error.code !== 'EEXIST') throw error;
    }
    if (!waited) say('Waiting for another build of this folder ...');
    await sleep(250);
    if (isAbandoned(file)) rmSync(file, {force: true});
  }
}

/** Returns whether the process that created the lock has ended without removing it. */
function isAbandoned(file) {
  try {
    const owner = Number(readFileSync(file, 'utf8'));
    if (owner === 0) return false; // not yet written
    process.kill(owner, 0);
    return false;
  } catch (error) {
    return error.code === 'ESRCH';
  }
}

if (import.meta.url === pathToFileURL(process.argv[1] ?? '').href) await main(buildNamed);
