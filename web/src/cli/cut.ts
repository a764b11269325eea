import type {CutSheet} from '../cutting/cut-sheet.js';
import type {DxfOptions} from '../cutting/out/sheet-dxf.js';
import {greatestAllowance} from '../cutting/allowance-rule.js';
import {printInks} from '../cutting/print-ink.js';
import {chosenNames} from '../model/garment/panel-marks.js';
import {titleOfFile} from '../model/garment/piece-names.js';
import {languages} from '../texts/preferences.js';
import {notAsSold} from '../picture/watermark.js';
import {noPaper, paperOf} from '../paper/papers.js';
import {cut as cutResult, type Cut} from '../node/index.js';
import {choice, lengthCm, parseArguments, UsageError, type Arguments} from './base/arguments.js';
import {countOf} from './base/count-of.js';
import {dxfFlags, dxfFormat} from './base/dxf-format.js';
import {checkDistinct, checkWritable, writeWhole} from './base/files.js';
import {print, remark} from './base/terminal.js';
import {readBytes} from '../node/files.js';
import {readRaster, readTile} from './base/print-files.js';
import {garmentOf, grainIn, plainIn, readFabricOf, readResult} from './result-file.js';

const sewAs1 = '--sew-as-1';
const dxfFlag = '--dxf';
const pdfFlag = '--pdf';
/** Files that may have several sizes. */
const nestFlags = [dxfFlag, pdfFlag];

/** Sheets of several sizes; the first is the sample size. */
interface Sizes {
  readonly dxf: DxfOptions;
  /** Returns the sheets of the sizes above each other. */
  readonly nested: () => Promise<readonly [Cut, ...Cut[]]>;
}

/** Output formats by flag. */
const outputs: Readonly<
  Record<string, (cut: Cut, sizes: Sizes) => Promise<string | Uint8Array> | string>
> = {
  [pdfFlag]: async (_, {nested}) => {
    const [first, ...others] = await nested();
    const {bytes, notes, layout} = await first.pdf(others);
    notes.forEach(remark);
    if (others.length > 0) {
      const {pages, paper} = layout;
      print(
        `${countOf(others.length + 1, 'size')} as layers on ${countOf(pages.length, 'page')}, ${paper.name}`,
      );
    }
    return bytes;
  },
  '--svg': (cut) => cut.svg(),
  [dxfFlag]: (cut, {dxf}) => cut.dxf(dxf),
  '--plt': (cut) => cut.hpgl(),
  '--map': (cut) => `${JSON.stringify(cut.map)}\n`,
};

const grammar = {
  files: ['the result file'],
  hasMore: true,
  valued: [
    ...[
      '--print',
      '--colourway',
      '--garment',
      '--allowance',
      '--hem',
      '--paper',
      '--ink',
      '--date',
      '--language',
      '--font',
    ],
    ...Object.keys(outputs),
    ...dxfFlags,
  ],
  switches: [sewAs1, '--guide', '--blank-pages'],
} as const;

interface Wanted {
  readonly flag: string;
  readonly path: string;
}

/** `cut`: writes cutting sheets of a result, or of several sizes, at true scale. */
export async function cut(words: readonly string[]): Promise<void> {
  const args = parseArguments(words, grammar);
  const [printFile, garmentFile] = ['--print', '--garment'].map((flag) => args.value(flag));
  if (printFile === undefined) throw new UsageError('--print PRINT.json is missing.');
  const settings = {...settingsOf(args), ...(await fontsOf(args))};
  const wanted = Object.keys(outputs).flatMap((flag): Wanted[] => {
    const path = args.value(flag);
    return path === undefined ? [] : [{flag, path}];
  });
  const format = dxfFormat(
    args,
    wanted.some(({flag}) => flag === dxfFlag),
  );
  checkSizes(args, wanted);
  const inputs = [...args.files, printFile, ...(garmentFile === undefined ? [] : [garmentFile])];
  checkDistinct(Object.fromEntries(wanted.map(({flag, path}) => [flag, path])));
  for (const {path} of wanted) await checkWritable(path, inputs);

  const cutters: Cutter[] = [];
  for (const file of args.files) cutters.push(await cutterOf(file, printFile, args, settings));
  const cuts = await Promise.all(cutters.map((cutter) => cutter()));
  const [first] = cuts;
  if (!first) throw new UsageError(`${grammar.files[0]} is missing.`);
  const sized = withSizes(args.files, cuts);
  const sizes: Sizes = {
    dxf: {...format, sewAsBoundary: args.has(sewAs1), ...sizesOf(sized)},
    nested: () => nestedCuts(sized, cutters),
  };
  const failed: unknown[] = [];
  for (const {flag, path} of wanted) {
    try {
      const content = await outputs[flag]?.(first, sizes);
      if (content !== undefined) await writeWhole(path, content);
    } catch (error) {
      failed.push(error); // other files are written in any case
    }
  }
  if (failed.length > 0) throw failed[0];
  cuts.forEach((done, k) => {
    print(figures(args.files[k] ?? '', done));
  });
  if (wanted.length === 0) {
    remark(`Nothing was written: name a file by ${Object.keys(outputs).join(', ')}.`);
  }
}

/** @throws {UsageError} for flags that only apply to a single size */
function checkSizes(args: Arguments, wanted: readonly Wanted[]): void {
  if (args.files.length < 2) return;
  const other = wanted.find(({flag}) => !nestFlags.includes(flag));
  if (other) {
    throw new UsageError(
      `Several sizes go into one file by ${nestFlags.join(' and ')} alone; write ${other.flag} of one result at a time.`,
    );
  }
  if (args.has('--guide')) {
    throw new UsageError('--guide is for one size; write it of one result at a time.');
  }
  if (args.value('--garment') !== undefined) {
    throw new UsageError(
      '--garment names one garment, but there are several results; cut results that hold theirs.',
    );
  }
}

/**
 * Names the sizes of several sheets. A garment without a size is called by its file.
 * @throws {UsageError} for two results of one size
 */
function withSizes(files: readonly string[], cuts: readonly Cut[]): readonly Cut[] {
  if (cuts.length < 2) return cuts;
  const fileOf = new Map<string, string>();
  return cuts.map((cut, k): Cut => {
    const file = files[k] ?? '';
    const {size = titleOfFile(file)} = cut.sheet;
    const same = fileOf.get(size);
    if (same !== undefined) {
      throw new UsageError(
        `${same} and ${file} are both of size ${size}; cut one result of each size.`,
      );
    }
    fileOf.set(size, file);
    return {...cut, sheet: {...cut.sheet, size}};
  });
}

/** Several sheets as sizes of one DXF file. */
function sizesOf(cuts: readonly Cut[]): Pick<DxfOptions, 'size' | 'otherSizes'> {
  const [sample, ...otherSizes] = cuts.map(({sheet}) => sheet);
  if (otherSizes.length === 0) return {};
  return {otherSizes, ...(sample?.size !== undefined && {size: sample.size})};
}

const areaOf = ({sheet: {widthCm, heightCm}}: Cut): number => widthCm * heightCm;

/** The sheets laid on that of the largest size. */
async function nestedCuts(
  cuts: readonly Cut[],
  cutters: readonly Cutter[],
): Promise<readonly [Cut, ...Cut[]]> {
  const [largest] = [...cuts].sort((a, b) => areaOf(b) - areaOf(a));
  const nested = cuts.map(async (cut, k): Promise<Cut> => {
    const laid = cut === largest ? undefined : await cutters[k]?.(largest?.sheet);
    if (!laid) return cut;
    const {size} = cut.sheet;
    return {...laid, sheet: {...laid.sheet, ...(size !== undefined && {size})}};
  });
  return (await Promise.all(nested)) as [Cut, ...Cut[]];
}

/** Lays out a sheet, alone or on that of a larger size. */
type Cutter = (under?: CutSheet) => Promise<Cut>;

/** @throws {UsageError}, {FileError} or {SolverError} with the name of an invalid file */
async function cutterOf(
  file: string,
  printFile: string,
  args: Arguments,
  settings: ReturnType<typeof settingsOf> & Awaited<ReturnType<typeof fontsOf>>,
): Promise<Cutter> {
  const colourway = args.value('--colourway');
  const {result} = await readResult(file);
  const fabric = await readFabricOf(result, file, {printFile, colourway});
  const tile = await readTile(fabric, printFile);
  const garment = await garmentOf(result, args.value('--garment'));
  if (!garment) {
    remark(
      `${file} does not hold its design, so pieces have no notches and no grain lines of their own; name the garment with --garment FILE.`,
    );
  }
  const whole = {
    ...settings,
    ...garment,
    ...(colourway !== undefined && {colourway}),
    print: {...fabric, ...(tile !== undefined && {tile})},
    names: chosenNames(result.design),
    grain: grainIn(result),
    plain: plainIn(result),
    pixels: () => readRaster(fabric, printFile),
    ...(result.reproduced === false && {mark: notAsSold}),
  };
  return (under) => cutResult(result, {...whole, ...(under && {under})});
}

/** @throws {FileError} if the font cannot be read */
async function fontsOf(args: Arguments) {
  const path = args.value('--font');
  return path === undefined ? {} : {fonts: [new Uint8Array(await readBytes(path))]};
}

/** @throws {UsageError} for an invalid value */
function settingsOf(args: Arguments) {
  const allowanceCm = lengthCm(args, '--allowance', greatestAllowance);
  const hemCm = lengthCm(args, '--hem', greatestAllowance);
  const paper = args.value('--paper');
  if (paper !== undefined && !paperOf(paper)) throw new UsageError(noPaper(paper));
  const ink = choice(args, '--ink', printInks);
  const language = choice(args, '--language', languages);
  const day = args.value('--date');
  const date = new Date(`${day ?? ''}T00:00:00Z`);
  if (day !== undefined && !(/^\d{4}-\d\d-\d\d$/.test(day) && Number.isFinite(date.getTime()))) {
    throw new UsageError(`--date is '${day}', but must be a day, such as 2026-03-21.`);
  }
  return {
    ...(allowanceCm !== undefined && {allowanceCm}),
    ...(hemCm !== undefined && {hemCm}),
    ...(paper !== undefined && {paper}),
    ...(ink && {ink}),
    ...(args.has('--guide') && {guide: true}),
    ...(args.has('--blank-pages') && {blankPages: true}),
    ...(language && {language}),
    ...(day !== undefined && {date}),
  };
}

function figures(resultFile: string, {sheet, layout}: Cut): string {
  const {pieces, widthCm, heightCm} = sheet;
  const {pages, paper} = layout;
  const size = (width: number, height: number): string =>
    `${width.toFixed(1)} x ${height.toFixed(1)} cm`;
  return [
    `${resultFile}: ${countOf(pieces.length, 'piece')} on a sheet of ${size(widthCm, heightCm)}`,
    `${countOf(pages.length, 'page')} of ${size(layout.widthCm, layout.heightCm)}, ${paper.name}`,
  ].join('; ');
}
