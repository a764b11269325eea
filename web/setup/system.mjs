import {spawnSync} from 'node:child_process';
import {existsSync, readdirSync} from 'node:fs';
import {join} from 'node:path';

import {chromiumPath} from './chromium.mjs';
import {clangTool} from './clang.mjs';
import {has, run, say, SetupError} from './shell.mjs';

// The same folders as in CMakeLists.txt.
const includes = [
  '/usr/include',
  '/usr/local/include',
  '/opt/homebrew/include',
  '/opt/local/include',
];
const header = (file) => includes.some((folder) => existsSync(join(folder, file)));

/** Emscripten from an activated emsdk, the PATH, or Arch's folder, which is not on it. */
function hasEmscripten() {
  const folders = [
    join(process.env.EMSDK ?? '/nowhere', 'upstream/emscripten'),
    '/usr/lib/emscripten',
  ];
  return has('em-config') || folders.some((folder) => existsSync(join(folder, 'em-config')));
}

/**
 * Returns whether clang has the library of its fuzzer, which Debian and Apple package separately.
 */
function hasFuzzer() {
  const clang = clangTool('clang');
  if (clang === undefined) return false;
  const {stdout} = spawnSync(clang, ['-print-runtime-dir'], {encoding: 'utf8'});
  const folder = stdout.trim();
  return existsSync(folder) && readdirSync(folder).some((name) => name.includes('fuzzer'));
}

// Requirements, each with a test of its presence and its package on every platform.
const cmake = {
  found: () => has('cmake'),
  apt: 'cmake',
  dnf: 'cmake',
  pacman: 'cmake',
  brew: 'cmake',
};
const ninja = {
  found: () => has('ninja') || has('ninja-build'),
  apt: 'ninja-build',
  dnf: 'ninja-build',
  pacman: 'ninja',
  brew: 'ninja',
};
const eigen = {
  found: () => header('eigen3/Eigen/Core') || header('Eigen/Core'),
  apt: 'libeigen3-dev',
  dnf: 'eigen3-devel',
  pacman: 'eigen',
  brew: 'eigen',
};
const json = {
  found: () => header('nlohmann/json.hpp'),
  apt: 'nlohmann-json3-dev',
  dnf: 'json-devel',
  pacman: 'nlohmann-json',
  brew: 'nlohmann-json',
};
const emscripten = {
  found: hasEmscripten,
  apt: 'emscripten',
  dnf: 'emscripten',
  pacman: 'emscripten',
  brew: 'emscripten',
};
const compiler = {
  found: () => has('c++'),
  apt: 'g++',
  dnf: 'gcc-c++ libasan libubsan',
  pacman: 'gcc',
  brew: '', // part of the command line tools, which Homebrew itself needs
};
const googletest = {
  found: () => header('gtest/gtest.h'),
  apt: 'libgtest-dev',
  dnf: 'gtest-devel',
  pacman: 'gtest',
  brew: 'googletest',
};

const clangFormat = {
  found: () => clangTool('clang-format') !== undefined,
  apt: 'clang-format',
  dnf: 'clang-tools-extra',
  pacman: 'clang',
  brew: 'clang-format',
};
const clangTidy = {
  found: () => clangTool('clang-tidy') !== undefined,
  apt: 'clang-tidy',
  dnf: 'clang-tools-extra',
  pacman: 'clang',
  brew: 'llvm',
};
/** A compiler with coverage-guided fuzzing. */
const fuzzer = {
  found: hasFuzzer,
  apt: 'clang libclang-rt-dev',
  dnf: 'clang compiler-rt',
  pacman: 'clang compiler-rt',
  brew: 'llvm',
};

const chromium = {
  found: () => existsSync(chromiumPath() ?? '/nowhere'),
  apt: 'chromium',
  dnf: 'chromium',
  pacman: 'chromium',
  brew: 'google-chrome',
};

/** A browser for tests that needs a third less processor time than Chromium. */
const headlessShell = {
  found: () => has('chromium-headless-shell'),
  apt: 'chromium-headless-shell',
};

const redis = {
  found: () => has('redis-server'),
  apt: 'redis-server',
  dnf: 'redis',
  pacman: 'redis',
  brew: 'redis',
};

const display = {
  found: () => has('xvfb-run'),
  apt: 'xvfb xauth',
};
const firefox = {
  found: () => has('firefox-esr'),
  apt: 'firefox-esr',
};
const webKit = {
  found: () => has('WebKitWebDriver'),
  apt: 'webkit2gtk-driver',
};

/**
 * Requirements of the module's build, of the native tests, of those in a browser, of batches, and
 * so on.
 */
export const forModule = [cmake, ninja, eigen, json, emscripten];
export const forNativeTests = [cmake, ninja, eigen, json, compiler, googletest];
export const forBrowserTests = [chromium];
export const forWebTests = [redis];
export const forFormat = [clangFormat];
export const forLint = [cmake, ninja, eigen, json, compiler, googletest, clangTidy];
export const forFuzzing = [cmake, ninja, eigen, json, fuzzer];
/** If one of these is missing, only the tests that need it are skipped. */
const forOtherBrowsers = [display, firefox, webKit];

/**
 * Installs missing requirements where that is allowed. @throws {SetupError} with the packages to
 * install
 */
export async function ensureSystem(needs) {
  await installMissing(needs);
  const missing = needs.filter((need) => !need.found());
  if (missing.length > 0) throw new SetupError(advice(missing));
}

/** Installs missing requirements where that is allowed. @returns whether all are there */
export async function hasOrInstalls(needs) {
  await installMissing(needs);
  return needs.every((need) => need.found());
}

/** Installs the faster browser for tests, if the distribution has it. */
export const installHeadlessShell = () => hasOrInstalls([headlessShell]);

/** Installs one by one, since not every distribution has all of them. */
export async function installOtherBrowsers() {
  for (const need of forOtherBrowsers) await installMissing([need]);
}

/** Installs missing requirements where that is allowed; elsewhere does nothing. */
async function installMissing(needs) {
  const missing = needs.filter((need) => !need.found());
  if (missing.length === 0 || !has('apt-get')) return;
  const administrator = await asAdministrator();
  if (!administrator) return;
  const names = [...new Set(missing.flatMap((need) => need.apt.split(' ')))];
  say(`Installing ${names.join(' ')} ...`);
  await aptInstall(administrator, names);
}

/** The prefix of a command that needs root; null if there is none. */
async function asAdministrator() {
  if (process.getuid?.() === 0) return [];
  const allowed = has('sudo') && (await run('sudo', ['-n', 'true'], {output: 'never'}));
  return allowed ? ['sudo', '-n'] : null;
}

async function aptInstall(administrator, packages) {
  const apt = (output, ...args) => {
    const settings = ['env', 'DEBIAN_FRONTEND=noninteractive', 'apt-get', '-qy'];
    const [command, ...rest] = [
      ...administrator,
      ...settings,
      ...['-o', 'DPkg::Lock::Timeout=600'],
      ...args,
    ];
    return run(command, rest, {output});
  };
  const install = ['install', '--no-install-recommends', ...packages];
  if (await apt('never', ...install)) return;
  say('Trying once more with fresh package lists ...');
  await apt('on failure', 'update');
  await apt('on failure', ...install);
}

function advice(missing) {
  const list = (platform) =>
    missing
      .map((need) => need[platform])
      .filter(Boolean)
      .join(' ');
  return `Some programs and libraries are missing. Install them, then run this command again:
  Debian, Ubuntu   sudo apt-get install --no-install-recommends ${list('apt')}
  Fedora           sudo dnf install ${list('dnf')}
  Arch             sudo pacman -S --needed ${list('pacman')}
  macOS            brew install ${list('brew')}
Instead of the package emscripten, an activated emsdk does as well (https://emscripten.org); instead
of chromium, any Chromium or Chrome that the environment variable CHROME_PATH names.`;
}
