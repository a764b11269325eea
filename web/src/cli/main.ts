#!/usr/bin/env node
import {SolverError} from '../model/failure.js';
import {packageVersion} from '../model/version.js';
import {FileError} from '../model/versioned-file.js';
import {align} from './align.js';
import {UsageError} from './arguments.js';
import {batch} from './batch/command.js';
import {draw} from './draw.js';
import {convertFile, listSymmetries} from './garments.js';
import {order} from './order.js';
import {print} from './terminal.js';
import {usage} from './usage.js';

const commands: Readonly<Record<string, (words: readonly string[]) => Promise<void>>> = {
  align,
  order,
  batch,
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
    print(packageVersion);
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

/** 2: the input is at fault. 1: anything else. */
function exitCode(error: unknown): 1 | 2 {
  if (error instanceof UsageError || error instanceof FileError) return 2;
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
