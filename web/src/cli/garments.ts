import {convert, symmetries} from '../node/index.js';
import {readText} from '../node/files.js';
import {parseArguments} from './base/arguments.js';
import {checkWritable, writeWhole} from './base/files.js';
import {print} from './base/terminal.js';

const grammar = {files: ['the garment file'], valued: ['--out'], switches: []};

/** `symmetries`: what `--symmetry auto` would find, in the format of a symmetry file. */
export async function listSymmetries(words: readonly string[]): Promise<void> {
  const {file, out} = await readArguments(words);
  await deliver(`${JSON.stringify(await symmetries(await readText(file), file), null, 1)}\n`, out);
}

/** `convert`: the garment in the project's own format. */
export async function convertFile(words: readonly string[]): Promise<void> {
  const {file, out} = await readArguments(words);
  await deliver(await convert(await readText(file), file), out);
}

async function readArguments(
  words: readonly string[],
): Promise<{readonly file: string; readonly out: string | undefined}> {
  const args = parseArguments(words, grammar);
  const [file = ''] = args.files;
  const out = args.value('--out');
  if (out !== undefined) await checkWritable(out);
  return {file, out};
}

async function deliver(text: string, out: string | undefined): Promise<void> {
  if (out === undefined) print(text);
  else await writeWhole(out, text);
}
