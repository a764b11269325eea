import {greatestAllowance} from '../cutting/allowance-rule.js';
import {convert, garmentDxf, symmetries} from '../node/index.js';
import {readGarmentText} from './base/garment-text.js';
import {choice, lengthCm, parseArguments, UsageError} from './base/arguments.js';
import {dxfFlags, dxfFormat} from './base/dxf-format.js';
import {checkWritable, writeWhole} from './base/files.js';
import {print} from './base/terminal.js';

const grammar = {files: ['the garment file'], valued: ['--out']};

/**
 * `symmetries`: prints the symmetries found by `--symmetry auto` in the format of a symmetry file.
 */
export async function listSymmetries(words: readonly string[]): Promise<void> {
  const {file, out} = await readArguments(words);
  await deliver(
    `${JSON.stringify(await symmetries(await readGarmentText(file), file), null, 1)}\n`,
    out,
  );
}

/** `convert`: writes the garment in the native format, as plain GarmentCode, or as DXF. */
export async function convertFile(words: readonly string[]): Promise<void> {
  const args = parseArguments(words, {
    ...grammar,
    valued: [...grammar.valued, '--to', '--allowance', ...dxfFlags],
    switches: ['--plain', '--divide-pleats', '--sew-as-1'],
  });
  const [file = ''] = args.files;
  const out = args.value('--out');
  const isDxf = choice(args, '--to', ['json', 'dxf']) === 'dxf';
  const allowanceCm = lengthCm(args, '--allowance', greatestAllowance);
  if (!isDxf && (allowanceCm !== undefined || args.has('--sew-as-1'))) {
    throw new UsageError('--allowance and --sew-as-1 belong to --to dxf, which is missing.');
  }
  const format = dxfFormat(args, isDxf, '--to dxf');
  if (out !== undefined) await checkWritable(out, [file]);
  const text = await readGarmentText(file);
  const sewAsBoundary = args.has('--sew-as-1');
  const converted = isDxf
    ? garmentDxf(text, {
        ...format,
        ...{name: file, sewAsBoundary},
        ...(allowanceCm !== undefined && {allowanceCm}),
      })
    : convert(text, {
        ...{name: file, plain: args.has('--plain')},
        dividePleats: args.has('--divide-pleats'),
      });
  await deliver(await converted, out);
}

async function readArguments(
  words: readonly string[],
): Promise<{readonly file: string; readonly out: string | undefined}> {
  const args = parseArguments(words, {...grammar, switches: []});
  const [file = ''] = args.files;
  const out = args.value('--out');
  if (out !== undefined) await checkWritable(out);
  return {file, out};
}

async function deliver(text: string, out: string | undefined): Promise<void> {
  if (out === undefined) print(text);
  else await writeWhole(out, text);
}
