import {basename} from 'node:path';

import type {SolveOptions} from '../model/options.js';
import type {Print} from '../model/print.js';
import {methods} from '../model/problem.js';
import type {SolveResult} from '../model/result.js';
import {solvedDesign} from '../model/solved-design.js';
import {solve} from '../node/index.js';
import {choice, parseArguments, UsageError, wholeNumber} from './arguments.js';
import {figuresLine} from './figures.js';
import {checkWritable, readText, writeText} from './files.js';
import {readPicture, readPrint} from './print-files.js';
import {print, ProgressLine, remark} from './terminal.js';

const grammar = {
  files: ['the garment file'],
  valued: ['--print', '--symmetry', '--method', '--options', '--seed', '--out'],
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
  const named = symmetryFile === 'auto' || symmetryFile === 'none';

  const garmentText = await readText(garmentFile);
  const printText = await readPrint(printFile);
  const optionsText = optionsFile === undefined ? '{}' : await readText(optionsFile);
  const problem = {
    garment: garmentText,
    print: printText,
    symmetry: named ? symmetryFile : await readText(symmetryFile),
    options: optionsText,
    method,
    seed,
  };
  const inputs = [garmentFile, printFile];
  if (!named) inputs.push(symmetryFile);
  if (optionsFile !== undefined) inputs.push(optionsFile);
  if (outFile !== undefined) await checkWritable(outFile, inputs);

  const progress = new ProgressLine();
  let result: SolveResult;
  try {
    result = await solve(problem, {
      onProgress: (step) => {
        progress.show(step);
      },
      names: {
        garment: garmentFile,
        print: printFile,
        symmetry: symmetryFile,
        options: optionsFile ?? 'options',
      },
    });
  } finally {
    progress.clear();
  }
  if (args.has('--no-times')) result = withoutTimes(result);
  if (outFile !== undefined) {
    const cloth = JSON.parse(printText) as Print;
    const design = solvedDesign(
      {
        garment: {name: basename(garmentFile), text: garmentText},
        print: cloth,
        picture: await readPicture(cloth, printFile),
        options: JSON.parse(optionsText) as SolveOptions,
      },
      result,
    );
    await writeText(outFile, `${JSON.stringify({...result, design})}\n`);
  }
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

/** Times are the one part of a result that differs from run to run. */
function withoutTimes(result: SolveResult): SolveResult {
  const milliseconds = {alignment: 0, deformation: 0, total: 0};
  return {...result, metrics: {...result.metrics, milliseconds}};
}
