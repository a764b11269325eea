import {execFile, spawnSync} from 'node:child_process';
import {createHash} from 'node:crypto';
import {existsSync, mkdirSync, readdirSync, readFileSync, writeFileSync} from 'node:fs';
import {availableParallelism} from 'node:os';
import {basename, join, resolve} from 'node:path';
import {promisify} from 'node:util';

import {has, root, run, say} from './shell.mjs';

/**
 * The only version whose findings are failures; others break lines elsewhere and have other checks.
 */
const version = 14;

/** The installed program of those tools, preferably of that version. */
export const clangTool = (name) => [`${name}-${version}`, name].find(has);

/** Returns whether a tool's findings are failures; otherwise prints a note. */
async function decides(program) {
  const {stdout} = await promisify(execFile)(program, ['--version']);
  const found = /version (\d+)/.exec(stdout)?.[1];
  if (found === String(version)) return true;
  say(`That is what ${program} ${found} finds; version ${version} decides, so it is no failure.`);
  return false;
}

/** Returns whether all C++ sources are formatted according to .clang-format. */
export async function checkFormat() {
  const files = ['wasm/src', 'tests'].flatMap((folder) =>
    readdirSync(join(root, folder), {recursive: true})
      .filter((name) => /\.(cpp|h)$/.test(name))
      .map((name) => join(folder, name)),
  );
  const program = clangTool('clang-format');
  if (await run(program, ['--dry-run', '--Werror', ...files], {output: 'on failure'})) return true;
  say(`To lay them out: ${program} -i FILE ...`);
  return !(await decides(program));
}

/** Units that are checked by themselves: their files use names that other units use as well. */
const ofTheirOwn = ['drape', 'io', 'marker', 'photo'];

/**
 * Runs clang-tidy over the core in five parts, so that Eigen is parsed and checked five times, not
 * for every file. A part that passed is left out until one of its files changes.
 * @param folder of a build whose core is compiled
 * @param isAnew whether to check all parts
 */
export async function tidy(folder, isAnew) {
  const commands = JSON.parse(readFileSync(join(root, folder, 'compile_commands.json'), 'utf8'));
  const units = new Map();
  for (const unit of commands.filter(({file}) => /[\\/]Unity[\\/]/.test(file))) {
    const [, first] = basename(unit.file).split('_');
    const name = ofTheirOwn.includes(first) ? first : 'solver';
    units.set(name, [...(units.get(name) ?? []), unit]);
  }
  const kept = join(root, 'build/tidy');
  mkdirSync(kept, {recursive: true});
  const program = clangTool('clang-tidy');
  let passed = units.size > 0;
  const left = [...units];
  const work = async () => {
    for (let next = left.pop(); next !== undefined; next = left.pop()) {
      const [name, parts] = next;
      const state = parts.map((part) => stateOf(folder, part)).join(' ');
      const stamp = join(kept, `${name}.passed`);
      if (!isAnew && existsSync(stamp) && readFileSync(stamp, 'utf8') === state) continue;
      const source = join(kept, `${name}.cpp`);
      writeFileSync(source, parts.map(({file}) => `#include "${file}"\n`).join(''));
      const words = ['--quiet', '--warnings-as-errors=*', source, '--', ...flagsOf(parts[0])];
      if (await run(program, words, {output: 'on failure'})) writeFileSync(stamp, state);
      else passed = false;
    }
  };
  await Promise.all(Array.from({length: availableParallelism()}, work));
  return passed || !(await decides(program));
}

/** Definitions, include folders and standard of a unit; the optimisation and its precompiled header are left out. */
function flagsOf({command}) {
  const words = command.match(/(?:[^\s"\\]|\\.|"(?:[^"\\]|\\.)*")+/g);
  const plain = words.map((word) => word.replaceAll(/\\(.)|"/g, '$1'));
  return plain.flatMap((word, k) =>
    word === '-isystem' ? [word, plain[k + 1]] : /^-(I|D|std=)/.test(word) ? [word] : [],
  );
}

/** The object file that a unit is compiled to, in the build's folder. */
const objectOf = ({command}) => / -o (\S+)/.exec(command)?.[1] ?? '';

/** Identifies a unit of a build by its command and the project's files that it includes. */
function stateOf(folder, unit) {
  const {stdout} = spawnSync('ninja', ['-C', folder, '-t', 'deps', objectOf(unit)], {
    cwd: root,
    encoding: 'utf8',
  });
  const files = stdout.split('\n').map((line) => resolve(root, folder, line.trim()));
  const sources = files.filter((file) => file.startsWith(join(root, 'wasm')) && existsSync(file));
  // a unit without a list of its files always counts as changed
  const hash = createHash('sha256').update(`${unit.command} ${sources.length || Date.now()}`);
  for (const file of [join(root, '.clang-tidy'), ...sources]) hash.update(readFileSync(file));
  return hash.digest('hex');
}
