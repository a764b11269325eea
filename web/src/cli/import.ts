import {
  importGarment,
  type FileUnit,
  type ImportOptions,
  type ImportReport,
} from '../node/index.js';
import {readBytes} from '../node/files.js';
import {numbersIn} from '../model/base/number-ranges.js';
import {drawingLimit} from '../node/import.js';
import {choice, lengthCm, parseArguments, UsageError, type Arguments} from './base/arguments.js';
import {checkWritable, writeWhole} from './base/files.js';
import {print, remark} from './base/terminal.js';
import {countOf} from './base/count-of.js';

const grammar = {
  files: ['the pattern file'],
  valued: [
    ...['--units', '--scale', '--measure', '--size', '--seams', '--out'],
    ...['--pages', '--grid', '--trim', '--overlap', '--allowance'],
  ],
  switches: ['--json'],
};

const units: Readonly<Record<'mm' | 'cm' | 'in', FileUnit>> = {mm: 'mm', cm: 'cm', in: 'inch'};

/** Pixels per inch, such as 300ppi, and their range. */
const density = /^(\d{1,5}(?:\.\d{1,4})?)ppi$/;
const densities = [10, 10_000] as const;

/** @throws {UsageError} for an unknown unit */
function unitOf(args: Arguments): Pick<ImportOptions, 'units' | 'pixelsPerInch'> {
  const [, pixels] = density.exec(args.value('--units') ?? '') ?? [];
  if (pixels === undefined) {
    const unit = choice(args, '--units', ['mm', 'cm', 'in'], 'pixels per inch, such as 300ppi');
    return unit ? {units: units[unit]} : {};
  }
  const [least, most] = densities;
  if (Number(pixels) >= least && Number(pixels) <= most) return {pixelsPerInch: Number(pixels)};
  throw new UsageError(`--units is '${pixels}ppi', but must be from ${least}ppi to ${most}ppi.`);
}

/** `import`: converts a pattern of another program to a garment. */
export async function importFile(words: readonly string[]): Promise<void> {
  const args = parseArguments(words, grammar);
  const [file = ''] = args.files;
  const unit = unitOf(args);
  const size = args.value('--size');
  const seams = choice(args, '--seams', ['suggest', 'file', 'none']);
  const out = args.value('--out');
  if (out !== undefined) await checkWritable(out, [file]);
  const pages = pagesIn(args);
  const grid = gridIn(args);
  const [trimCm, overlapCm, allowanceCm] = (['--trim', '--overlap', '--allowance'] as const).map(
    (flag) => lengthCm(args, flag, widest),
  );
  const {garment, report} = await importGarment(await readBytes(file, drawingLimit), {
    name: file,
    ...{...unit, ...scaleIn(args)},
    ...(size !== undefined && {size}),
    ...(seams && {seams}),
    ...(pages && {pages}),
    ...(grid && {grid}),
    ...(trimCm !== undefined && {trimCm}),
    ...(overlapCm !== undefined && {overlapCm}),
    ...(allowanceCm !== undefined && {allowanceCm}),
  });
  if (out !== undefined) await writeWhole(out, garment);
  if (args.has('--json')) {
    print(`${JSON.stringify(report)}\n`);
    return;
  }
  report.notes.forEach(remark);
  print(listOf(file, report));
}

/** Greatest scale 1 : n, and greatest length of a piece. [cm] */
const [greatestScale, longest] = [100, 500];

/** @throws {UsageError} for a scale that is none */
function scaleIn(args: Arguments): Pick<ImportOptions, 'scale' | 'measured'> {
  const [ratio, measure] = [args.value('--scale'), args.value('--measure')];
  if (ratio !== undefined && measure !== undefined) {
    throw new UsageError('--scale and --measure both set the scale; leave one out.');
  }
  if (ratio !== undefined) {
    const scale = Number(/^1:(\d+(?:\.\d+)?)$/.exec(ratio)?.[1]);
    if (scale > 0 && scale <= greatestScale) return {scale};
    throw new UsageError(`--scale is '${ratio}', but must be from 1:0.01 to 1:100, such as 1:5.`);
  }
  if (measure === undefined) return {};
  const [, piece = '', length] = /^(.+)=(\d+(?:\.\d+)?)$/.exec(measure) ?? [];
  const longerCm = Number(length);
  if (longerCm > 0 && longerCm <= longest) return {measured: {piece, longerCm}};
  throw new UsageError(
    `--measure is '${measure}', but must be a piece and its longer side in cm, such as front=62.5.`,
  );
}

/** Greatest trim, overlap and allowance. [cm] */
const widest = 10;

function pagesIn(args: Arguments): readonly number[] | undefined {
  const value = args.value('--pages');
  if (value === undefined) return undefined;
  const numbers = numbersIn(value);
  if (numbers) return numbers;
  throw new UsageError(`--pages is '${value}', but must be page numbers such as 3-26 or 1,4-6.`);
}

function gridIn(args: Arguments): readonly [columns: number, rows: number] | undefined {
  const value = args.value('--grid');
  if (value === undefined) return undefined;
  const [, columns, rows] = /^([1-9]\d?)x([1-9]\d?)$/.exec(value) ?? [];
  if (columns !== undefined && rows !== undefined) return [Number(columns), Number(rows)];
  throw new UsageError(`--grid is '${value}', but must be columns and rows such as 4x6.`);
}

const cm = (length: number): string => length.toFixed(1);

const unitNames: Readonly<Record<string, string>> = {
  ...{mm: 'millimetres', cm: 'centimetres', in: 'inches', m: 'metres'},
};

/** One line for the file, then one for each piece. */
function listOf(
  file: string,
  {pieces, sizes, size, units: {used, from}, seams}: ImportReport,
): string {
  const taken = pieces.filter((piece) => piece.taken);
  const inSize =
    size === null ? '' : `, size ${size}${sizes.length > 1 ? ` of ${sizes.join(', ')}` : ''}`;
  const origin = {file: 'as the file says', flag: 'as asked for', guess: 'guessed from size'}[from];
  return [
    `${file}: ${countOf(taken.length, 'piece')}${inSize}, in ${unitNames[used] ?? used} (${origin}), ${countOf(seams.length, 'seam')}`,
    ...taken.map(
      ({name, widthCm, heightCm, quantity, notches}) =>
        `${name}: ${cm(widthCm)} x ${cm(heightCm)} cm, cut ${String(quantity)}, ${notches} ${notches === 1 ? 'notch' : 'notches'}`,
    ),
  ].join('\n');
}
