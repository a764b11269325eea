import type {DxfFormat} from '../model/base/dxf-format.js';
import {panelMarks} from '../model/garment/panel-marks.js';
import type {Point} from '../model/geometry/vectors.js';
import type {CheaperLay, LayPlan} from '../model/result/marker-plan.js';
import {naps, type MarkerProgress} from '../model/result/marker-search.js';
import {readable, titleOfFile} from '../model/garment/piece-names.js';
import {asCut} from '../model/print/as-cut.js';
import type {Print} from '../model/print/repeating-print.js';
import {listOf, Malformed, number, pairOf} from '../model/base/read.js';
import {readText} from '../node/files.js';
import {
  layPlanFiles,
  layPlanText,
  marker as layResults,
  type LayPlanFiles,
  type MarkerGarment,
  type NodeMarkerSettings,
} from '../node/index.js';
import {
  choice,
  factor,
  lengthCm,
  parseArguments,
  UsageError,
  wholeNumber,
  type Arguments,
} from './base/arguments.js';
import {dxfFlags, dxfFormat} from './base/dxf-format.js';
import {checkDistinct, checkWritable, writeWhole} from './base/files.js';
import {
  layCounts,
  layLengths,
  layRange,
  laySettings,
  shifts,
  type LayWish,
} from './base/lay-wish.js';
import {readRaster, readTile} from './base/print-files.js';
import {print, remark, StatusLine} from './base/terminal.js';
import {countOf} from './base/count-of.js';
import {readLaidFiles} from './laid-files.js';
import {parsed} from './result-file.js';

type Content = string | Uint8Array;

interface Written {
  readonly files: LayPlanFiles;
  readonly plan: LayPlan;
  readonly format: DxfFormat;
}

const dxfFlag = '--dxf';

/** Output formats by flag. */
const outputs: Readonly<Record<string, (written: Written) => Content | Promise<Content>>> = {
  '--out': ({plan}) => layPlanText(plan),
  '--svg': ({files}) => files.svg(),
  '--pdf': ({files}) => pages(files, 10),
  '--plotter': ({files}) => pages(files, 1),
  [dxfFlag]: ({files, format}) => files.dxf(format),
  '--plt': ({files}) => files.hpgl(),
};

async function pages({pdf}: LayPlanFiles, scale: 10 | 1): Promise<Uint8Array> {
  const {bytes, notes} = await pdf(scale);
  notes.forEach(remark);
  return bytes;
}

const flagsOf = (names: readonly string[]): string[] => names.map((name) => `--${name}`);

const grammar = {
  files: ['the result or project file'],
  hasMore: true,
  valued: [
    ...['--print', '--garment', '--copies', '--phase', '--nap', '--shift', '--flaws', '--effort'],
    ...flagsOf(layLengths),
    ...flagsOf(layCounts),
    ...Object.keys(outputs),
    ...dxfFlags,
  ],
  switches: ['--free', '--fold', '--json'],
} as const;

/** `marker`: lays the pieces of results out on their printed fabric. */
export async function marker(words: readonly string[]): Promise<void> {
  const args = parseArguments(words, grammar);
  const [printFile, garmentFile, flawsFile] = ['--print', '--garment', '--flaws'].map((flag) =>
    args.value(flag),
  );
  if (printFile === undefined) throw new UsageError('--print PRINT.json is missing.');
  if (garmentFile !== undefined && args.files.length > 1) {
    throw new UsageError(
      '--garment names one garment, but there are several results; lay results that hold theirs.',
    );
  }
  const wish = wishOf(args);
  const settings = laySettings(wish);
  const others = [garmentFile, flawsFile].filter((file) => file !== undefined);
  const wanted = Object.entries(outputs).flatMap(([flag, content]) => {
    const path = args.value(flag);
    return path === undefined ? [] : [{flag, path, content}];
  });
  const format = dxfFormat(
    args,
    wanted.some(({flag}) => flag === dxfFlag),
  );
  checkDistinct(Object.fromEntries(wanted.map(({flag, path}) => [flag, path])));
  for (const {path} of wanted) await checkWritable(path, [...args.files, printFile, ...others]);

  const flaws = flawsFile === undefined ? undefined : await readFlaws(flawsFile);
  const laid = await readLaidFiles(args.files, {printFile, garmentFile});
  if (typeof wish.copies === 'object' && wish.copies.length !== laid.length) {
    throw new UsageError(
      `--copies has ${countOf(wish.copies.length, 'number')}, but there are ${countOf(laid.length, 'garment')}; a project has its own numbers, so leave --copies out.`,
    );
  }
  const [{fabric} = {fabric: undefined}] = laid;
  if (!fabric) throw new UsageError('The result file is missing.');
  const {plan, milliseconds} = await timed(
    laid.map(({garment}, k) => ({...garment, ...copiesOf(wish, k)})),
    {...settings, print: fabric, ...(flaws && {flaws})},
  );
  const called = laid.map((one) => one.called);
  const files = await filesOf(plan, laid, {fabric, printFile, resultFiles: called});
  for (const {path, content} of wanted) {
    await writeWhole(path, await content({files, plan, format}));
  }
  report(args, plan, milliseconds, called);
}

async function filesOf(
  plan: LayPlan,
  laid: readonly {readonly garment: MarkerGarment}[],
  {
    fabric,
    printFile,
    resultFiles,
  }: {
    readonly fabric: Print;
    readonly printFile: string;
    readonly resultFiles: readonly string[];
  },
): Promise<LayPlanFiles> {
  const tile = await readTile(fabric, printFile);
  const called = laid.map(
    ({garment: {garment, names}}) =>
      (piece: string): string | undefined =>
        garment && panelMarks(garment, {...(names && {names})}).get(piece)?.label,
  );
  return layPlanFiles(plan, {
    print: {...asCut(fabric), ...(tile !== undefined && {tile})},
    results: laid.map(({garment}) => garment),
    names: (result, piece) => called[result]?.(piece) ?? readable(piece),
    title: resultFiles.map(titleOfFile).join(', '),
    pixels: () => readRaster(fabric, printFile),
  });
}

/** The number of garments of one result, if each result has its own. */
function copiesOf({copies}: LayWish, k: number): Pick<MarkerGarment, 'copies'> {
  const own = typeof copies === 'object' ? copies[k] : undefined;
  return own === undefined ? {} : {copies: own};
}

/**
 * The number of garments of each result: one number for all, or a list.
 * @throws {UsageError} for other values, or a list of another length
 */
function copiesIn(args: Arguments): Pick<LayWish, 'copies'> {
  const value = args.value('--copies');
  if (value === undefined) return {};
  const [least, most] = layRange('copies');
  const numbers = value.split(',').map((part) => (/^\d{1,4}$/.test(part) ? Number(part) : NaN));
  if (!numbers.every((count) => count >= least && count <= most)) {
    throw new UsageError(
      `--copies is '${value}', but must be a whole number from ${least} to ${most}, or one for each result, such as 2,1.`,
    );
  }
  const [all = 1] = numbers;
  if (numbers.length === 1) return {copies: all};
  if (numbers.length === args.files.length) return {copies: numbers};
  throw new UsageError(
    `--copies has ${countOf(numbers.length, 'number')} for ${countOf(args.files.length, 'result')}; give one for all, or one for each.`,
  );
}

/** @throws {UsageError} for an invalid value */
function wishOf(args: Arguments): LayWish {
  const width = lengthCm(args, '--width', layRange('width')[1]);
  if (width === undefined) throw new UsageError('--width CM, how wide the fabric is, is missing.');
  const given = <K extends string>(names: readonly K[], read: (name: K) => number | undefined) =>
    Object.fromEntries(
      names.flatMap((name) => {
        const value = read(name);
        return value === undefined ? [] : [[name, value]];
      }),
    );
  const place = args.value('--phase');
  const nap = choice(args, '--nap', naps);
  const shift = choice(args, '--shift', shifts);
  const effort = factor(args, '--effort', layRange('effort'));
  return {
    width,
    ...given(layLengths, (name) => lengthCm(args, `--${name}`, layRange(name)[1])),
    ...given(layCounts, (name) => wholeNumber(args, `--${name}`, layRange(name))),
    ...copiesIn(args),
    ...(place !== 'any' && given(['phase'], () => lengthCm(args, '--phase', layRange('phase')[1]))),
    ...(nap && {nap}),
    ...(shift && {shift}),
    ...(effort !== undefined && {effort}),
    ...{free: args.has('--free'), fold: args.has('--fold')},
  };
}

const polygons = listOf(listOf(pairOf(number(-1e6, 1e6))));

/**
 * @throws {UsageError} if the file is no list of flaws
 * @throws {FileError} if it cannot be read
 */
async function readFlaws(file: string): Promise<readonly (readonly Point[])[]> {
  try {
    return polygons(parsed(await readText(file), file), 'flaws');
  } catch (error) {
    if (!(error instanceof Malformed)) throw error;
    throw new UsageError(
      `${file} is no list of flaws (${error.message}); write polygons as lists of points [x, y] in cm.`,
    );
  }
}

const stages: Readonly<Record<MarkerProgress['stage'], string>> = {
  tables: 'Comparing pieces',
  lay: 'Laying pieces',
  prove: 'Looking for a proof',
  free: 'Laying without the print',
  widths: 'Laying on other widths',
  shifts: 'Moving the print under pieces',
  done: 'Laid',
};

/** Computes the layout with a progress display and measures the time. */
async function timed(
  garments: readonly MarkerGarment[],
  settings: NodeMarkerSettings,
): Promise<{readonly plan: LayPlan; readonly milliseconds: number}> {
  const status = new StatusLine();
  const started = performance.now();
  let best = '';
  try {
    const plan = await layResults(garments, settings, {
      onLayout: ({lengthCm: length}) => {
        best = `, ${length.toFixed(1)} cm so far`;
      },
      onProgress: ({stage, fraction}) => {
        status.write(`${stages[stage]}, ${Math.floor(100 * fraction)} %${best}`);
      },
    });
    return {plan, milliseconds: Math.round(performance.now() - started)};
  } finally {
    status.clear();
  }
}

function report(
  args: Arguments,
  plan: LayPlan,
  milliseconds: number,
  called: readonly string[],
): void {
  const {placements, unplaced, notes, cheaper, ...figures} = plan;
  if (args.has('--json')) {
    const results = args.files;
    const pieces = placements.length;
    print(JSON.stringify({results, pieces, ...figures, cheaper, unplaced, notes, milliseconds}));
    return;
  }
  notes.forEach(remark);
  cheaper.map((offer) => cheaperWords(plan, offer)).forEach(remark);
  sharesOf(called, plan).forEach(remark);
  print(line(args.files, plan));
}

/** One line for each of several garments: its share of the length. */
function sharesOf(files: readonly string[], {garments = []}: LayPlan): readonly string[] {
  if (garments.length < 2) return [];
  return garments.map(
    ({result, copies, pieces, lengthCm: length}) =>
      `${files[result] ?? ''}: ${countOf(copies, 'garment')}, ${countOf(pieces, 'piece')}, ${cm(length)} of the length.`,
  );
}

function cheaperWords({lengthCm: length}: LayPlan, offer: CheaperLay): string {
  const {kind, lengthCm, phaseCm = 0, pieces = [], design} = offer;
  const names = [...new Set(pieces)].join(', ');
  const [mean, instead] = [design?.meanCm ?? 0, design?.insteadOfCm ?? 0].map(millimetres);
  const how = {
    phase: `if the print starts ${cm(phaseCm)} from the left edge`,
    shift: `if the print may move under ${names}, where it fits as well`,
    unmatched: `if the print need not match on ${names}`,
    design: `with another placing that fits as well: ${mean} instead of ${instead} mm on average; the plan has its pins`,
  };
  return `${cm(length - lengthCm)} less ${how[kind]}.`;
}

const millimetres = (length: number): string => (10 * length).toFixed(1);

const cm = (length: number): string => `${length.toFixed(1)} cm`;

function line(files: readonly string[], plan: LayPlan): string {
  const {placements, unplaced, widthCm, lengthCm, useShare, boundCm, proven} = plan;
  const free = plan.printOrigin ? plan.freeLengthCm : null;
  return [
    `${files.join(', ')}: ${countOf(placements.length, 'piece')} on ${cm(lengthCm)} of fabric ${widthCm} cm wide`,
    `${(100 * useShare).toFixed(1)} % of it used`,
    ...(proven ? ['proven the shortest'] : []),
    ...(!proven && boundCm > 0 ? [`${cm(boundCm)} at the least`] : []),
    ...(free === null ? [] : [`${cm(free)} without regard to the print`]),
    ...(unplaced.length > 0 ? [`${unplaced.length} found no place`] : []),
  ].join('; ');
}
