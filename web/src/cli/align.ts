import {basename} from 'node:path';

import {optionLimits} from '../model/base/core-tables.js';
import type {PrintSizes, SolveOptions} from '../model/design/options.js';
import type {ComparedAnswer} from '../model/design/solve-problem.js';
import {scaleLimits} from '../model/print/print-scale.js';
import {asVariant, mostTurn, type PrintVariant} from '../model/print/print-variant.js';
import {repeatOf} from '../model/print/repeat.js';
import type {Print} from '../model/print/repeating-print.js';
import {asSewn, withFabric} from '../model/print/as-sewn.js';
import {methods} from '../model/result/method.js';
import {resultText, withoutTimes} from '../model/documents/result-text.js';
import type {SeamGroup, SolveResult} from '../model/result/result.js';
import {readText, textOf} from '../node/files.js';
import {
  chosenProblem,
  commonPrintSize,
  readGarment,
  remedies,
  solve,
  withReach,
  type Problem,
  type ProblemNames,
  type Remedy,
} from '../node/index.js';
import {
  type Arguments,
  choice,
  factor,
  lengthCm,
  parseArguments,
  printSizes,
  printTurns,
  UsageError,
  wholeNumber,
} from './base/arguments.js';
import {deliveredFor} from './base/delivered-flags.js';
import {figuresLine, remedyLine} from './figures.js';
import {grainChoices, withGrainChoices} from './base/grain-choice.js';
import {checkDistinct, checkWritable, writeWhole} from './base/files.js';
import {readGarmentBytes} from './base/garment-text.js';
import {readPicture, readPrint} from './base/print-files.js';
import type {Aligned, Chosen} from './stored.js';
import {advise, print as printLine, ProgressLine, remark} from './base/terminal.js';

const grammar = {
  files: ['the garment file'],
  hasMore: true,
  valued: [
    ...['--print', '--symmetry', '--method', '--options', '--max-change', '--effort', '--seed'],
    ...['--print-size', '--print-turn', '--shrinkage', '--measured'],
    ...['--grain-line', '--out', '--design'],
  ],
  repeated: ['--grain-line'],
  switches: ['--json', '--no-times', '--no-remedies', '--others'],
} as const;

/** Time for remedies, enough for garments of 60 pieces. [s] */
const remedySeconds = 60;

/** `align`: solves garments, all in one size of their print, and prints their figures. */
export async function align(words: readonly string[]): Promise<void> {
  const args = parseArguments(words, grammar);
  const [first = '', ...others] = args.files;
  if (others.length === 0) {
    await alignOne(args, first);
    return;
  }
  const outputs = args.files.map((file) => ({file, ...outputsOf(args, file)}));
  checkDistinct(Object.fromEntries(outputs.map(({outFile}, k) => [`--out ${k + 1}`, outFile])));
  if (typeof printTurns(args, '--print-turn', mostTurn) === 'object') {
    throw new UsageError(
      '--print-turn is one turn for several garments, since their fabric has one; name one number.',
    );
  }
  const sizes = printSizes(args, '--print-size', scaleLimits);
  const isSwept = typeof sizes === 'object';
  const printSize = isSwept ? await sizeForAll(args, sizes) : sizes;
  for (const {file, ...output} of outputs) await alignOne(args, file, {...output, printSize});
}

/** Output files of one garment, and the size of the print. */
interface OfOne {
  readonly outFile: string | undefined;
  readonly designFile: string | undefined;
  readonly printSize: PrintSizes | undefined;
}

/** Mark in the names of output files for the name of the garment's file. */
const mark = '{garment}';

/** @throws {UsageError} if a file has the same name for all garments */
function outputsOf(args: Arguments, garmentFile: string): Pick<OfOne, 'outFile' | 'designFile'> {
  const name = basename(garmentFile).replace(/\.json$/i, '');
  const [outFile, designFile] = ['--out', '--design'].map((flag) => {
    const path = args.value(flag);
    if (path !== undefined && !path.includes(mark)) {
      throw new UsageError(
        `${flag} names one file for ${args.files.length} garments; write ${mark} in its name, such as out/${mark}.result.json.`,
      );
    }
    return path?.replaceAll(mark, name);
  });
  return {outFile, designFile};
}

/** The size of the print in which most seams of all garments match. */
async function sizeForAll(args: Arguments, sizes: PrintSizes): Promise<number> {
  const problems = await Promise.all(args.files.map((file) => givenOf(args, file, undefined)));
  const progress = new ProgressLine();
  const compared: string[] = [];
  try {
    const scale = await commonPrintSize(
      problems.map(({given}) => problemOf(given)),
      sizes,
      {
        names: problems.map(({names}) => names),
        onSolve: (size, k) => {
          progress.write(`Print at ${percent(size)}, ${args.files[k] ?? ''}`);
        },
        onCompared: ({scale: size, matched, visible}) => {
          compared.push(`${percent(size)}: ${matched} of ${visible}`);
        },
        onRefused: (size, reason) => {
          remark(`The print at ${size} times its size cannot be solved: ${messageOf(reason)}`);
        },
      },
    );
    remark(`Visible seams of all garments that match: ${compared.join('; ')}.`);
    return scale;
  } finally {
    progress.clear();
  }
}

const percent = (scale: number): string => `${String(Number((100 * scale).toFixed(1)))} %`;

/** Reads the input of one garment. */
async function givenOf(
  args: Arguments,
  garmentFile: string,
  size: PrintSizes | undefined,
): Promise<{
  readonly given: Aligned;
  readonly names: ProblemNames;
  readonly inputs: readonly string[];
}> {
  const printFile = args.value('--print');
  if (printFile === undefined) throw new UsageError('--print PRINT.json is missing.');
  const method = choice(args, '--method', methods) ?? 'best';
  const seed = wholeNumber(args, '--seed') ?? 1;
  const symmetryFile = args.value('--symmetry') ?? 'auto';
  const optionsFile = args.value('--options');
  const decided = {
    maxChangeCm: lengthCm(args, '--max-change', optionLimits.maxChangeCm[1]),
    effort: factor(args, '--effort', optionLimits.effort, 'auto'),
    printSize: size,
    printTurn: printTurns(args, '--print-turn', mostTurn),
  };
  const named = symmetryFile === 'auto' || symmetryFile === 'none';

  const bytes = await readGarmentBytes(garmentFile);
  const lines = args.values('--grain-line');
  const grains =
    lines.length > 0 ? grainChoices(await readGarment(textOf(bytes), garmentFile), lines) : {};
  const options = optionsFile === undefined ? '{}' : await readText(optionsFile);
  const print = {path: printFile, bytes: await readPrint(printFile)};
  const delivered = deliveredFor(args, print);
  const given: Aligned = {
    garment: {path: garmentFile, bytes},
    ...{print, ...(delivered && {delivered})},
    symmetry: named ? symmetryFile : await readText(symmetryFile),
    options: withDecided(withGrainChoices(options, grains), decided),
    ...{method, seed},
  };
  const inputs = [garmentFile, printFile];
  if (!named) inputs.push(symmetryFile);
  if (optionsFile !== undefined) inputs.push(optionsFile);
  const names: ProblemNames = {
    garment: garmentFile,
    print: printFile,
    symmetry: symmetryFile,
    options: optionsFile ?? 'options',
  };
  return {given, names, inputs};
}

/** Solves one garment, writes its files and prints its figures. */
async function alignOne(
  args: Arguments,
  garmentFile: string,
  {outFile, designFile, printSize}: OfOne = {
    outFile: args.value('--out'),
    designFile: args.value('--design'),
    printSize: printSizes(args, '--print-size', scaleLimits),
  },
): Promise<void> {
  const {given, names, inputs} = await givenOf(args, garmentFile, printSize);
  await checkOutputs(outFile, designFile, inputs);
  const exact = args.has('--no-times');
  const wants = {
    remedies: !exact && !args.has('--no-remedies'),
    others: args.has('--others'),
  };
  const {result, found, compared, seamGroups} = await solved(given, names, wants);
  // a stored design is compared with the result itself
  const shown = {...result, ...(seamGroups && {seamGroups})};
  const chosen = chosenFor(given, result);
  if (outFile !== undefined) {
    await writeWhole(
      outFile,
      exact ? resultText(result) : await openable(chosen, {result, found, shown}),
    );
  }
  if (designFile !== undefined) {
    const {storedText} = await import('./stored.js');
    await writeWhole(designFile, storedText(designFile, chosen, result));
  }
  if (args.has('--json')) {
    printLine(
      JSON.stringify({
        garment: garmentFile,
        group: result.print.group,
        ...(exact ? withoutTimes(result) : result).metrics,
        notes: result.notes,
        ...(compared.length > 0 && {...variantOf(result), compared}),
        ...(found && {remedies: found}),
      }),
    );
  } else {
    result.notes.forEach(remark);
    printLine(
      figuresLine(garmentFile, exact ? withoutTimes(result) : shown, {
        garment: await readGarment(textOf(given.garment.bytes), names.garment),
        options: JSON.parse(chosen.options) as SolveOptions,
        compared,
      }),
    );
    found?.map(remedyLine).forEach(advise);
  }
}

interface Solved {
  readonly result: SolveResult;
  /** Undefined if remedies were not requested. */
  readonly found?: readonly Remedy[];
  /** Seams with those marked that do not match even by themselves; with remedies only. */
  readonly seamGroups?: readonly SeamGroup[];
  /** Answers that were compared; empty for a problem of one solve. */
  readonly compared: readonly ComparedAnswer[];
}

/** Solves with a progress display, and searches for remedies if requested. */
async function solved(
  given: Aligned,
  names: ProblemNames,
  wants: {readonly remedies: boolean; readonly others: boolean},
): Promise<Solved> {
  const progress = new ProgressLine();
  const problem = problemOf(given);
  // output options of this run are no part of the design
  const others = wants.others ? {otherAlignments: true} : {};
  const compared: ComparedAnswer[] = [];
  try {
    const result = await solve(
      {...problem, options: withDecided(given.options, others)},
      {
        onProgress: (step) => {
          progress.show(step);
        },
        onCompared: (answer) => compared.push(answer),
        onRefused: ({scale, turnDeg, reason}) => {
          const turned = turnDeg === 0 ? '' : `, turned by ${turnDeg} degrees,`;
          remark(
            `The print at ${scale} times its size${turned} cannot be solved: ${messageOf(reason)}`,
          );
        },
        names,
      },
    );
    if (!wants.remedies) return {result, compared};
    progress.write(`Looking for remedies, for at most ${String(remedySeconds)} s`);
    return {result, compared, ...(await afterwards(problem, result, names))};
  } finally {
    progress.clear();
  }
}

/** Searches for remedies and for seams beyond reach until the time for it is over. */
async function afterwards(
  problem: Problem,
  result: SolveResult,
  names: ProblemNames,
): Promise<Pick<Solved, 'found' | 'seamGroups'>> {
  const found: Remedy[] = [];
  const signal = AbortSignal.timeout(1000 * remedySeconds);
  try {
    await remedies(problem, result, {names, signal, onRemedy: (remedy) => found.push(remedy)});
    const {seamGroups} = await withReach(problem, result, {names, signal});
    return {found, ...(seamGroups && {seamGroups})};
  } catch (error) {
    if (!signal.aborted) throw error;
    remark(
      `The search for remedies ended after ${String(remedySeconds)} s with ${found.length === 0 ? 'none' : String(found.length)}; --no-remedies leaves it out.`,
    );
    return {found};
  }
}

/**
 * Adds options from flags, which override the file. Invalid JSON is returned unchanged, and the
 * solver reports it.
 */
function withDecided(options: string, decided: Readonly<Record<string, unknown>>): string {
  const given = Object.entries(decided).filter(([, value]) => value !== undefined);
  if (given.length === 0) return options;
  try {
    return JSON.stringify({...(JSON.parse(options) as object), ...Object.fromEntries(given)});
  } catch {
    return options;
  }
}

/** The problem with size, turn and seed that gave the result. */
function chosenFor(given: Aligned, result: SolveResult): Chosen {
  const {options = '{}', seed = given.seed} = chosenProblem(problemOf(given), result);
  const {scale = 1, turnDeg = 0} = JSON.parse(textOf(given.print.bytes)) as Print;
  const solved = variantOf(result);
  return {
    ...given,
    ...{options: typeof options === 'string' ? options : JSON.stringify(options), seed},
    variant: {scale: solved.scale / scale, turnDeg: solved.turnDeg - turnDeg},
  };
}

const variantOf = ({print: {scale = 1, turnDeg = 0}}: SolveResult): PrintVariant => ({
  scale,
  turnDeg,
});

const problemOf = ({delivered, ...given}: Aligned) => ({
  ...given,
  garment: textOf(given.garment.bytes),
  print: delivered
    ? withFabric(JSON.parse(textOf(given.print.bytes)) as Print, delivered)
    : textOf(given.print.bytes),
});

const messageOf = (reason: unknown): string =>
  reason instanceof Error ? reason.message : String(reason);

async function checkOutputs(
  outFile: string | undefined,
  designFile: string | undefined,
  inputs: readonly string[],
): Promise<void> {
  if (outFile !== undefined) await checkWritable(outFile, inputs);
  if (designFile !== undefined) await checkWritable(designFile, inputs);
  checkDistinct({'--out': outFile, '--design': designFile});
}

/** The result with its design, so that a page can open it, and with its remedies. */
async function openable(
  {garment, print, options, seed, variant, delivered}: Chosen,
  {
    result,
    found,
    shown,
  }: {
    readonly result: SolveResult;
    readonly found: readonly Remedy[] | undefined;
    readonly shown: SolveResult;
  },
): Promise<string> {
  const {solvedDesign} = await import('../model/design/solved-design.js');
  const {written} = await import('../model/design/written-design.js');
  const file = JSON.parse(textOf(print.bytes)) as Print;
  const varied = asVariant(file, variant);
  const fabric = asSewn(withFabric(varied, delivered ?? {}));
  const {group, cell = 'primitive'} = varied;
  const design = solvedDesign(
    {
      garment: {name: basename(garment.path), text: textOf(garment.bytes)},
      print: fabric,
      stated: {group, cell, ...repeatOf(varied)},
      picture: await readPicture(fabric, print.path),
      options: JSON.parse(options) as SolveOptions,
      seed,
    },
    result,
  );
  return `${JSON.stringify({...shown, ...(found && {remedies: found}), design: written(design)})}\n`;
}
