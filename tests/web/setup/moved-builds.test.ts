import {
  cpSync,
  existsSync,
  mkdirSync,
  mkdtempSync,
  readFileSync,
  renameSync,
  rmSync,
  writeFileSync,
} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';

import {afterEach, beforeEach, expect, it} from 'vitest';

import {configure, forgetMoved} from '../../../web/setup/cmake.mjs';

let home = '';
beforeEach(() => {
  home = mkdtempSync(join(tmpdir(), 'seamwise-setup-'));
});
afterEach(() => {
  rmSync(home, {recursive: true});
});

/** A checkout that was configured at its current path. */
function checkout(name: string): string {
  const project = join(home, name);
  mkdirSync(join(project, 'build/wasm'), {recursive: true});
  const cache = `CMAKE_BUILD_TYPE:STRING=Release\nCMAKE_HOME_DIRECTORY:INTERNAL=${project}\n`;
  writeFileSync(join(project, 'build/wasm/CMakeCache.txt'), cache);
  return project;
}

it('keeps a build that was made where it lies', () => {
  const project = checkout('one');
  expect(forgetMoved(join(project, 'build/wasm'), `${project}/`)).toBe(false);
  expect(existsSync(join(project, 'build/wasm/CMakeCache.txt'))).toBe(true);
});

it('begins the build of a moved checkout anew', () => {
  const project = join(home, 'moved');
  renameSync(checkout('one'), project);
  expect(forgetMoved(join(project, 'build/wasm'), project)).toBe(true);
  expect(existsSync(join(project, 'build/wasm'))).toBe(false);
});

it('begins the build of a copy anew, and leaves that of the original alone', () => {
  const original = checkout('one');
  const copy = checkout('two');
  writeFileSync(
    join(copy, 'build/wasm/CMakeCache.txt'),
    `CMAKE_HOME_DIRECTORY:INTERNAL=${original}\n`,
  );
  expect(forgetMoved(join(copy, 'build/wasm'), copy)).toBe(true);
  expect(existsSync(join(copy, 'build/wasm'))).toBe(false);
  expect(existsSync(join(original, 'build/wasm'))).toBe(true);
});

it('has nothing to forget where nothing was built', () => {
  expect(forgetMoved(join(home, 'build/wasm'), home)).toBe(false);
});

/** A project that CMake configures without searching for a compiler. */
function project(name: string): string {
  const folder = join(home, name);
  mkdirSync(folder);
  writeFileSync(
    join(folder, 'CMakeLists.txt'),
    `cmake_minimum_required(VERSION 3.22)
    project(small LANGUAGES NONE)
    set(TOOL one CACHE STRING "what it is made with")
    if(NOT TOOL STREQUAL "one")
      message(FATAL_ERROR "\${TOOL} is gone")
    endif()`,
  );
  const binaryDir = '$' + '{sourceDir}/build/small';
  const presets = {version: 3, configurePresets: [{name: 'small', generator: 'Ninja', binaryDir}]};
  writeFileSync(join(folder, 'CMakePresets.json'), JSON.stringify(presets));
  return folder;
}

const source = (folder: string): string | undefined =>
  /^CMAKE_HOME_DIRECTORY:INTERNAL=.*\/(.*)$/m.exec(
    readFileSync(join(folder, 'build/small/CMakeCache.txt'), 'utf8'),
  )?.[1];

it('configures again where a build was copied or moved to', async () => {
  const first = project('first');
  expect(await configure('small', [], first)).toBe(true);
  const [copied, moved] = [join(home, 'copied'), join(home, 'moved')];
  cpSync(first, copied, {recursive: true});
  renameSync(first, moved);
  for (const folder of [copied, moved]) expect(await configure('small', [], folder)).toBe(true);
  expect([source(copied), source(moved)]).toEqual(['copied', 'moved']);
});

it('drops settings that are of no use any more, and keeps what has been compiled', async () => {
  const folder = project('one');
  const compiled = join(folder, 'build/small/CMakeFiles/small.dir');
  expect(await configure('small', [], folder)).toBe(true);
  mkdirSync(compiled);
  const cache = join(folder, 'build/small/CMakeCache.txt');
  writeFileSync(cache, readFileSync(cache, 'utf8').replace('TOOL:STRING=one', 'TOOL:STRING=two'));
  expect(await configure('small', [], folder)).toBe(true);
  expect(readFileSync(cache, 'utf8')).toContain('TOOL:STRING=one');
  expect(existsSync(compiled)).toBe(true);
});
