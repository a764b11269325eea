import {SolverError} from '../model/base/failure.js';
import {packageVersion} from '../model/base/version.js';
import {UsageError} from './base/arguments.js';
import {print} from './base/terminal.js';

type Command = (words: readonly string[]) => Promise<void>;

/** Loaded on demand, since loading all scripts takes as long as solving a small garment. */
const commands: Readonly<Record<string, () => Promise<Command>>> = {
  align: async () => (await import('./align.js')).align,
  order: async () => (await import('./order.js')).order,
  batch: async () => (await import('./batch/command.js')).batch,
  symmetries: async () => (await import('./garments.js')).listSymmetries,
  import: async () => (await import('./import.js')).importFile,
  convert: async () => (await import('./garments.js')).convertFile,
  draw: async () => (await import('./draw.js')).draw,
  cut: async () => (await import('./cut.js')).cut,
  marker: async () => (await import('./marker.js')).marker,
  repeat: async () => (await import('./repeat.js')).repeat,
  photo: async () => (await import('./photo.js')).photo,
  drape: async () => (await import('./drape.js')).drape,
  seams: async () => (await import('./seams.js')).listSeams,
  dump: async () => (await import('./dump.js')).dump,
};

async function runCommand([command, ...words]: readonly string[]): Promise<void> {
  if (command === '--help' || command === '-h' || words.includes('--help')) {
    const {usage, usageOf} = await import('./usage.js');
    print(usageOf(command ?? '') ?? usage);
    return;
  }
  if (command === '--version') {
    print(packageVersion);
    return;
  }
  if (command === undefined) throw new UsageError('a command is missing; see --help.');
  const load = Object.hasOwn(commands, command) ? commands[command] : undefined;
  if (!load) {
    const known = Object.keys(commands).join(', ');
    throw new UsageError(`unknown command '${command}'; there are ${known}.`);
  }
  const run = await load();
  await run(words);
}

/** Exit code 2 for invalid input, 1 for any other error. */
function exitCode(error: unknown): 1 | 2 {
  if (error instanceof UsageError) return 2;
  return error instanceof SolverError && error.code !== 'internal' ? 2 : 1;
}

/**
 * Runs a command. Prints an error as one sentence, and sets the exit code of the process.
 * @param words  command and arguments
 */
export async function run(words: readonly string[]): Promise<void> {
  try {
    await runCommand(words);
  } catch (error) {
    const sentence = error instanceof Error ? error.message : String(error);
    process.stderr.write(`seamwise: ${sentence.replaceAll(/\s*\n\s*/g, ' ')}\n`);
    process.exitCode = exitCode(error);
  }
}
