import {existsSync, mkdirSync, mkdtempSync, renameSync, rmSync, writeFileSync} from 'node:fs';
import {tmpdir} from 'node:os';
import {join} from 'node:path';

import {afterEach, beforeEach, expect, it} from 'vitest';

import {forgetMoved} from '../../web/setup/cmake.mjs';

let home = '';
beforeEach(() => {
  home = mkdtempSync(join(tmpdir(), 'seamwise-setup-'));
});
afterEach(() => {
  rmSync(home, {recursive: true});
});

/** A checkout that was configured where it lies. */
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
