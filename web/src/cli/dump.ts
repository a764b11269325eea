import {mkdir} from 'node:fs/promises';
import {join} from 'node:path';

import {alignmentsFrom} from '../model/geometry/vectors.js';
import {methods} from '../model/result/method.js';
import type {MeshedPattern} from '../model/result/result.js';
import {fileError, readText, textOf} from '../node/files.js';
import {readGarmentText} from './base/garment-text.js';
import {solve} from '../node/index.js';
import {drawStage, type Stage} from '../picture/draw-result.js';
import {choice, parseArguments, UsageError, wholeNumber} from './base/arguments.js';
import {writeWhole} from './base/files.js';
import {readPrint} from './base/print-files.js';
import {print} from './base/terminal.js';

const grammar = {
  files: ['the garment file'],
  valued: ['--print', '--symmetry', '--method', '--options', '--seed', '--out'],
  switches: [],
};

/** `dump`: draws the stages of a solve, one image each. */
export async function dump(words: readonly string[]): Promise<void> {
  const args = parseArguments(words, grammar);
  const [garmentFile = ''] = args.files;
  const [printFile, folder] = ['--print', '--out'].map((flag) => args.value(flag));
  if (printFile === undefined) throw new UsageError('--print PRINT.json is missing.');
  if (folder === undefined) throw new UsageError('--out FOLDER is missing.');
  const symmetry = args.value('--symmetry') ?? 'auto';
  const options = args.value('--options');
  const problem = {
    garment: await readGarmentText(garmentFile),
    print: textOf(await readPrint(printFile)),
    symmetry: symmetry === 'auto' || symmetry === 'none' ? symmetry : await readText(symmetry),
    options: options === undefined ? '{}' : await readText(options),
    method: choice(args, '--method', methods) ?? 'best',
    seed: wholeNumber(args, '--seed') ?? 1,
  };
  const names = {garment: garmentFile, print: printFile, symmetry, options: options ?? 'options'};
  try {
    await mkdir(folder, {recursive: true});
  } catch (error) {
    throw fileError(error, folder, 'written');
  }
  for (const [number, stage] of (await stages(problem, names)).entries()) {
    const file = join(folder, `${String(number).padStart(3, '0')}-${stage.title}.svg`);
    await writeWhole(file, drawStage(stage));
    print(file);
  }
}

/**
 * The drafted pattern, each better alignment found by the search, the placed and the shaped
 * pattern.
 */
async function stages(
  problem: Parameters<typeof solve>[0],
  names: NonNullable<NonNullable<Parameters<typeof solve>[1]>['names']>,
): Promise<readonly Stage[]> {
  let pattern: MeshedPattern | undefined;
  const found: Float64Array[] = [];
  const result = await solve(problem, {
    names,
    onPattern: (meshed) => {
      pattern = meshed;
    },
    onPartial: (alignments) => {
      if (found.at(-1)?.join() !== alignments.join()) found.push(alignments);
    },
  });
  const placed = result.pieces.map(({alignment}) => alignment);
  const rest = {pattern: pattern ?? result, outline: 'rest'} as const;
  const drafted = rest.pattern.pieces.map(({alignment}) => alignment);
  return [
    {...rest, title: 'drafted', alignments: drafted},
    ...found.map((numbers) => ({...rest, title: 'search', alignments: alignmentsFrom(numbers)})),
    {...rest, title: 'placed', alignments: placed},
    {pattern: result, outline: 'shape', title: 'shaped', alignments: placed},
  ];
}
