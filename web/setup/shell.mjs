import {AsyncLocalStorage} from 'node:async_hooks';
import {spawn, spawnSync} from 'node:child_process';
import {readFileSync} from 'node:fs';
import {join} from 'node:path';
import {fileURLToPath} from 'node:url';

/** The project's folder. */
export const root = fileURLToPath(new URL('../..', import.meta.url));

/** A failed step; only its message is printed, without a stack. */
export class SetupError extends Error {
  name = 'SetupError';
}

/** Buffers for the output of simultaneous work until it ends. */
const outputs = new AsyncLocalStorage();

/** Prints the output of some work when it ends, so that it is not mixed with that of other work. */
export async function collected(work) {
  const output = [];
  try {
    return await outputs.run(output, work);
  } finally {
    process.stderr.write(Buffer.concat(output));
  }
}

/** Prints progress on standard error: standard output is for results. */
export function say(text) {
  const output = outputs.getStore();
  if (output) output.push(Buffer.from(`${text}\n`));
  else process.stderr.write(`${text}\n`);
}

/** Returns whether a command is on the PATH. */
export function has(command) {
  const finder = process.platform === 'win32' ? 'where' : 'which';
  return spawnSync(finder, [command], {stdio: 'ignore'}).status === 0;
}

/**
 * Runs a command in the project's folder.
 * @param output  when to show its output: 'always' (on standard error), only 'on failure', 'never',
 * or unbuffered ('inherit')
 * @returns whether it succeeded
 */
export function run(command, args, {output = 'always', env = {}} = {}) {
  return new Promise((resolve, reject) => {
    const said = [];
    const kept = output === 'always' ? outputs.getStore() : undefined;
    const stream = kept ? 'pipe' : ({always: 2, inherit: 'inherit'}[output] ?? 'pipe');
    const child = spawn(command, args, {
      cwd: root,
      env: {...process.env, ...env},
      stdio: ['ignore', stream, stream],
    });
    child.stdout?.on('data', (chunk) => said.push(chunk));
    child.stderr?.on('data', (chunk) => said.push(chunk));
    child.on('error', (error) => reject(new SetupError(`${command}: ${error.message}`)));
    child.on('close', (code) => {
      const print = (bytes) => outputs.getStore()?.push(bytes) ?? process.stderr.write(bytes);
      if (kept || (code !== 0 && output === 'on failure')) print(Buffer.concat(said));
      resolve(code === 0);
    });
  });
}

/** Runs a command that has to succeed, quietly. @throws {SetupError} when it fails */
export async function must(command, args, {env = {}} = {}) {
  if (!(await run(command, args, {output: 'on failure', env}))) {
    throw new SetupError(`failed: ${[command, ...args].join(' ')}`);
  }
}

/** The command that runs a program of an installed npm package, on every platform. */
export function tool(name, program = name) {
  const folder = join(root, 'node_modules', name);
  const {bin} = JSON.parse(readFileSync(join(folder, 'package.json'), 'utf8'));
  return [process.execPath, join(folder, typeof bin === 'string' ? bin : bin[program])];
}

/** Runs a script's main function; a failure ends it with exit code 1. */
export async function main(script) {
  try {
    await script();
  } catch (error) {
    say(error instanceof SetupError ? error.message : (error.stack ?? String(error)));
    process.exitCode = 1;
  }
}
