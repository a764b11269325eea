#!/usr/bin/env node
import {readFile} from 'node:fs/promises';

import {SolverError} from '../model/failure.js';
import {align} from './align.js';
import {UsageError} from './arguments.js';
import {draw} from './draw.js';
import {convertFile, listSymmetries} from './garments.js';
import {print} from './terminal.js';
import {usage} from './usage.js';

const commands: Readonly<Record<string, (words: readonly string[]) => Promise<void>>> = {
  align,
  symmetries: listSymmetries,
  convert: convertFile,
  draw,
};

async function main([command, ...words]: readonly string[]): Promise<void> {
  if (command === '--help' || command === '-h' || words.includes('--help')) {
    print(usage);
    return;
  }
  if (command === '--version') {
    print(await version());
    return;
  }
  if (command === undefined) throw new UsageError('a command is missing; see --help.');
  const run = Object.hasOwn(commands, command) ? commands[command] : undefined;
  if (!run) {
    const known = Object.keys(commands).join(', ');
    throw new UsageError(`unknown command '${command}'; there are ${known}.`);
  }
  await run(words);
}

/** The version in package.json, which is two folders up from here, in the package as in the repository. */
async function version(): Promise<string> {
  const text = await readFile(new URL('../../package.json', import.meta.url), 'utf8');
  return (JSON.parse(text) as {readonly version: string}).version;
}

/** 2: the input is at fault. 1: anything else. */
function exitCode(error: unknown): 1 | 2 {
  if (error instanceof UsageError) return 2;
  return error instanceof SolverError && error.code !== 'internal' ? 2 : 1;
}

// A reader that has seen enough (`| head -1`) is no error.
process.stdout.on('error', () => process.exit());

try {
  await main(process.argv.slice(2));
} catch (error) {
  const sentence = error instanceof Error ? error.message : String(error);
  process.stderr.write(`seamwise: ${sentence.replaceAll(/\s*\n\s*/g, ' ')}\n`);
  process.exitCode = exitCode(error);
}
