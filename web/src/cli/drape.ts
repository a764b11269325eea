import {extname, resolve} from 'node:path';
import {pathToFileURL} from 'node:url';

import {
  fabricNames,
  formSizes,
  type Drape,
  type DrapeProgress,
  type DrapeSettings,
  type Measurements,
} from '../model/result/draped-garment.js';
import {drapeFile, drapeText, type DrapeFile} from '../model/documents/drape-file.js';
import {glb} from '../files/glb/glb.js';
import {titleOfFile} from '../model/garment/piece-names.js';
import {fieldOf} from '../model/base/read.js';
import {sha256Of} from '../model/documents/result-text.js';
import {readText, textOf} from '../node/files.js';
import {drape as drapeResult} from '../node/index.js';
import {choice, parseArguments, UsageError, type Arguments} from './base/arguments.js';
import {checkDistinct, checkWritable, writeWhole} from './base/files.js';
import {print, remark, StatusLine} from './base/terminal.js';
import {readCell} from './base/cell-picture.js';
import {parsed, plainIn, readFabricOf, readResult, type ResultFile} from './result-file.js';
import {countOf} from './base/count-of.js';

const grammar = {
  files: ['the result file'],
  valued: [
    ...['--print', '--colourway', '--fabric', '--size', '--body', '--effort'],
    ...['--out', '--glb', '--png'],
  ],
  switches: ['--json', '--no-times', '--attributes', '--form'],
};

const efforts = {1: 1, 2: 2, 4: 4} as const;

/** `drape`: drapes a result on a form. */
export async function drape(words: readonly string[]): Promise<void> {
  const args = parseArguments(words, grammar);
  const [resultFile = ''] = args.files;
  const printFile = args.value('--print');
  if (printFile === undefined) throw new UsageError('--print PRINT.json is missing.');
  const [outFile, glbFile, bodyFile] = ['--out', '--glb', '--body'].map((flag) => args.value(flag));
  checkFlags(args, glbFile);
  const {bytes, result} = await readResult(resultFile);
  const settings = {...fabricIn(result), ...(await settingsOf(args, bodyFile))};
  const fabric = await readFabricOf(result, resultFile, {
    printFile,
    colourway: args.value('--colourway'),
  });
  const inputs = [resultFile, printFile, ...(bodyFile === undefined ? [] : [bodyFile])];
  for (const file of [outFile, glbFile]) {
    if (file !== undefined) await checkWritable(file, inputs);
  }
  const picture =
    glbFile === undefined ? undefined : await readCell(fabric, pathToFileURL(resolve(printFile)));
  if (glbFile !== undefined && !picture) {
    remark(`${printFile} has no image, so the fabric in ${glbFile} is white.`);
  }

  const {draped, milliseconds} = await timed(textOf(bytes), settings, {
    result: resultFile,
    ...(bodyFile !== undefined && {body: bodyFile}),
  });
  const file = drapeFile(result, draped, settings, args.has('--no-times') ? 0 : milliseconds);
  if (outFile !== undefined) await writeWhole(outFile, drapeText(file));
  if (glbFile !== undefined) {
    const scene = glb(result, draped, fabric, {
      ...(picture && {picture}),
      ...{plain: plainIn(result), garment: titleOfFile(resultFile), sha256: sha256Of(bytes)},
      ...{attributes: args.has('--attributes'), form: args.has('--form')},
    });
    await writeWhole(glbFile, scene);
  }
  report(resultFile, file, args.has('--json'));
}

/** @throws {UsageError} for unusable flags */
function checkFlags(args: Arguments, glbFile: string | undefined): void {
  if (args.value('--png') !== undefined) {
    throw new UsageError(
      '--png needs a renderer, which Node has not; write --glb, or save the picture from a page that shows the garment.',
    );
  }
  if (glbFile !== undefined && extname(glbFile).toLowerCase() !== '.glb') {
    throw new UsageError(`${glbFile} would hold binary glTF; name a file ending in .glb.`);
  }
  const idle = ['--attributes', '--form'].find((flag) => args.has(flag));
  if (idle !== undefined && glbFile === undefined) {
    throw new UsageError(`${idle} belongs to --glb FILE.glb, which is missing.`);
  }
  checkDistinct({'--out': args.value('--out'), '--glb': glbFile});
}

/**
 * @throws {UsageError} for invalid flags
 * @throws {FileError} if the body file cannot be read
 */
async function settingsOf(args: Arguments, bodyFile: string | undefined): Promise<DrapeSettings> {
  const fabric = choice(args, '--fabric', fabricNames);
  const size = choice(args, '--size', formSizes);
  const effort = choice(args, '--effort', ['1', '2', '4']);
  if (size !== undefined && bodyFile !== undefined) {
    throw new UsageError('--size and --body both say how large the form is; give one.');
  }
  return {
    ...(fabric !== undefined && {fabric}),
    ...(size !== undefined && {size}),
    // the core reports missing measurements
    ...(bodyFile !== undefined && {
      body: parsed(await readText(bodyFile), bodyFile) as Measurements,
    }),
    ...(effort !== undefined && {effort: efforts[effort]}),
  };
}

const stages: Readonly<Record<DrapeProgress['stage'], string>> = {
  sew: 'Sewing',
  hang: 'Hanging',
  settle: 'Settling',
  done: 'Settled',
};

/** Drapes with a progress display and measures the time. */
async function timed(
  result: string,
  settings: DrapeSettings,
  names: {readonly result: string; readonly body?: string},
): Promise<{readonly draped: Drape; readonly milliseconds: number}> {
  const status = new StatusLine();
  const started = performance.now();
  try {
    const draped = await drapeResult(result, settings, {
      names,
      onProgress: ({stage, fraction}) => {
        status.write(`${stages[stage]}, ${Math.floor(100 * fraction)} %`);
      },
    });
    return {draped, milliseconds: Math.round(performance.now() - started)};
  } finally {
    status.clear();
  }
}

/** The fabric of the result's design, if any. */
function fabricIn({design}: ResultFile): Pick<DrapeSettings, 'fabric'> {
  const fabric = fabricNames.find((name) => name === fieldOf(design, 'fabric'));
  return {...(fabric && {fabric})};
}

function report(resultFile: string, file: DrapeFile, asJson: boolean): void {
  const {pieces, fabric, check, stages: done, notes, metrics} = file;
  const triangles = pieces.reduce((count, piece) => count + piece.triangles.length, 0);
  const work = done.reduce((all, stage) => all + stage.work, 0);
  if (asJson) {
    print(
      JSON.stringify({
        ...{result: resultFile, fabric: fabric.name, effort: file.effort, triangles},
        ...{check, work, milliseconds: metrics.milliseconds, notes},
      }),
    );
    return;
  }
  notes.forEach(remark);
  print(
    [
      `${resultFile}: ${countOf(pieces.length, 'piece')} of ${fabric.name}, ${triangles} triangles`,
      `seams closed to ${(10 * check.gap).toFixed(1)} mm`,
      `stretched by ${percent(check.tension.median)} in the middle, ${percent(check.tension.max)} at the most`,
      `${(10 * check.depth).toFixed(1)} mm into the form`,
      countOf(check.crossings, 'crossing'),
      `${metrics.milliseconds} ms`,
    ].join('; '),
  );
}

const percent = (share: number): string => `${(100 * share).toFixed(1)} %`;
