import {execFile, spawnSync} from 'node:child_process';
import {createHash} from 'node:crypto';
import {existsSync, mkdirSync, readdirSync, readFileSync, writeFileSync} from 'node:fs';
import {availableParallelism} from 'node:os';
import {join, resolve} from 'node:path';
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

/**
 * Runs clang-tidy over the core. Its units are those of the build, one a folder, so that Eigen is
 * parsed a dozen times instead of for every file. A unit that passed is skipped until one of its
 * files changes.
 * @param folder  of a build whose core is compiled
 * @param isAnew  whether to check all units
 */
export async function tidy(folder, isAnew) {
  const commands = JSON.parse(readFileSync(join(root, folder, 'compile_commands.json'), 'utf8'));
  const units = commands.filter(({file}) => /[\\/]Unity[\\/]/.test(file));
  const kept = join(root, 'build/tidy');
  mkdirSync(kept, {recursive: true});
  // clang does not support all of GCC's warning options
  const flags = ['-p', folder, '--quiet', '--extra-arg=-Wno-unknown-warning-option'];
  const program = clangTool('clang-tidy');
  let passed = units.length > 0;
  const work = async () => {
    for (let unit = units.pop(); unit !== undefined; unit = units.pop()) {
      const state = stateOf(folder, unit);
      const stamp = join(kept, `${objectOf(unit).replaceAll(/\W/g, '_')}.passed`);
      if (!isAnew && existsSync(stamp) && readFileSync(stamp, 'utf8') === state) continue;
      const words = [...flags, '--warnings-as-errors=*', unit.file];
      if (await run(program, words, {output: 'on failure'})) writeFileSync(stamp, state);
      else passed = false;
    }
  };
  await Promise.all(Array.from({length: availableParallelism()}, work));
  return passed || !(await decides(program));
}

/** The object file of a unit, in the build's folder. */
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
