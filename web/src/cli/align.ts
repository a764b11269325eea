import {basename, resolve} from 'node:path';

import type {SolveOptions} from '../model/options.js';
import type {Print} from '../model/print.js';
import {methods} from '../model/problem.js';
import {resultText, withoutTimes} from '../model/result-text.js';
import type {SolveResult} from '../model/result.js';
import {solvedDesign} from '../model/solved-design.js';
import {readBytes, readText, textOf} from '../node/files.js';
import {solve} from '../node/index.js';
import {choice, parseArguments, UsageError, wholeNumber} from './arguments.js';
import {figuresLine} from './figures.js';
import {checkWritable, writeText} from './files.js';
import {readPicture, readPrint} from './print-files.js';
import {storedText, type Aligned} from './stored.js';
import {print, ProgressLine, remark} from './terminal.js';

const grammar = {
  files: ['the garment file'],
  valued: ['--print', '--symmetry', '--method', '--options', '--seed', '--out', '--design'],
  switches: ['--json', '--no-times'],
};

/** `align`: solves a garment and prints its figures. */
export async function align(words: readonly string[]): Promise<void> {
  const args = parseArguments(words, grammar);
  const [garmentFile = ''] = args.files;
  const printFile = args.value('--print');
  if (printFile === undefined) throw new UsageError('--print PRINT.json is missing.');
  const method = choice(args, '--method', methods) ?? 'best';
  const seed = wholeNumber(args, '--seed') ?? 1;
  const symmetryFile = args.value('--symmetry') ?? 'auto';
  const optionsFile = args.value('--options');
  const outFile = args.value('--out');
  const designFile = args.value('--design');
  const named = symmetryFile === 'auto' || symmetryFile === 'none';

  const given: Aligned = {
    garment: {path: garmentFile, bytes: await readBytes(garmentFile)},
    print: {path: printFile, bytes: await readPrint(printFile)},
    symmetry: named ? symmetryFile : await readText(symmetryFile),
    options: optionsFile === undefined ? '{}' : await readText(optionsFile),
    ...{method, seed},
  };
  const inputs = [garmentFile, printFile];
  if (!named) inputs.push(symmetryFile);
  if (optionsFile !== undefined) inputs.push(optionsFile);
  await checkOutputs(outFile, designFile, inputs);

  const progress = new ProgressLine();
  let result: SolveResult;
  try {
    result = await solve(
      {...given, garment: textOf(given.garment.bytes), print: textOf(given.print.bytes)},
      {
        onProgress: (step) => {
          progress.show(step);
        },
        names: {
          garment: garmentFile,
          print: printFile,
          symmetry: symmetryFile,
          options: optionsFile ?? 'options',
        },
      },
    );
  } finally {
    progress.clear();
  }
  if (args.has('--no-times')) result = withoutTimes(result);
  if (outFile !== undefined) {
    const text = args.has('--no-times') ? resultText(result) : await openable(given, result);
    await writeText(outFile, text);
  }
  if (designFile !== undefined) await writeText(designFile, storedText(designFile, given, result));
  if (args.has('--json')) {
    print(
      JSON.stringify({
        garment: garmentFile,
        group: result.print.group,
        ...result.metrics,
        notes: result.notes,
      }),
    );
  } else {
    result.notes.forEach(remark);
    print(figuresLine(garmentFile, result));
  }
}

async function checkOutputs(
  outFile: string | undefined,
  designFile: string | undefined,
  inputs: readonly string[],
): Promise<void> {
  if (outFile !== undefined) await checkWritable(outFile, inputs);
  if (designFile === undefined) return;
  await checkWritable(designFile, inputs);
  if (outFile !== undefined && resolve(outFile) === resolve(designFile)) {
    throw new UsageError('--out and --design name the same file; name two.');
  }
}

/** A result with the design that it answers, which lets a page open it. */
async function openable({garment, print, options}: Aligned, result: SolveResult): Promise<string> {
  const cloth = JSON.parse(textOf(print.bytes)) as Print;
  const design = solvedDesign(
    {
      garment: {name: basename(garment.path), text: textOf(garment.bytes)},
      print: cloth,
      picture: await readPicture(cloth, print.path),
      options: JSON.parse(options) as SolveOptions,
    },
    result,
  );
  return `${JSON.stringify({...result, design})}\n`;
}
