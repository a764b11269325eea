import {execFile} from 'node:child_process';
import {readdirSync, readFileSync} from 'node:fs';
import {availableParallelism} from 'node:os';
import {join} from 'node:path';
import {promisify} from 'node:util';

import {has, root, run, say} from './shell.mjs';

/** Other versions break lines elsewhere and have other checks: this one decides. */
const version = 14;

/** The program that a machine has of those tools. */
export const clangTool = (name) => [`${name}-${version}`, name].find(has);

/** Whether what a tool has found is a failure; if not, says so. */
async function decides(program) {
  const {stdout} = await promisify(execFile)(program, ['--version']);
  const found = /version (\d+)/.exec(stdout)?.[1];
  if (found === String(version)) return true;
  say(`That is what ${program} ${found} finds; version ${version} decides, so it is no failure.`);
  return false;
}

/** Whether all C++ sources are laid out as .clang-format says. */
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
 * Runs clang-tidy over the core. Its units are those of the build, one a folder, so that Eigen is parsed a dozen
 * times, not for every file.
 * @param folder of a build that has been configured
 */
export async function tidy(folder) {
  const commands = JSON.parse(readFileSync(join(root, folder, 'compile_commands.json'), 'utf8'));
  const units = commands.map(({file}) => file).filter((file) => /[\\/]Unity[\\/]/.test(file));
  // what GCC is told to leave out is unknown to clang
  const flags = ['-p', folder, '--quiet', '--extra-arg=-Wno-unknown-warning-option'];
  const program = clangTool('clang-tidy');
  let passed = units.length > 0;
  const work = async () => {
    for (let unit = units.pop(); unit !== undefined; unit = units.pop()) {
      const words = [...flags, '--warnings-as-errors=*', unit];
      if (!(await run(program, words, {output: 'on failure'}))) passed = false;
    }
  };
  await Promise.all(Array.from({length: availableParallelism()}, work));
  return passed || !(await decides(program));
}
