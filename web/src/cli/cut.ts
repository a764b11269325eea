import {greatestAllowance} from '../cutting/allowance-rule.js';
import {printInks} from '../cutting/print-ink.js';
import {chosenNames} from '../model/garment/panel-marks.js';
import {notAsSold} from '../picture/watermark.js';
import {noPaper, paperOf} from '../paper/papers.js';
import {cut as cutResult, type Cut} from '../node/index.js';
import {choice, lengthCm, parseArguments, UsageError, type Arguments} from './base/arguments.js';
import {checkDistinct, checkWritable, writeWhole} from './base/files.js';
import {print, remark} from './base/terminal.js';
import {readRaster, readTile} from './base/print-files.js';
import {garmentOf, plainIn, readFabricOf, readResult} from './result-file.js';

/** Output formats by flag. */
const outputs: Readonly<
  Record<string, (cut: Cut, args: Arguments) => Promise<string | Uint8Array> | string>
> = {
  '--pdf': async (cut) => {
    const {bytes, notes} = await cut.pdf();
    notes.forEach(remark);
    return bytes;
  },
  '--svg': (cut) => cut.svg(),
  '--dxf': (cut, args) => cut.dxf({sewAsBoundary: args.has('--sew-as-1')}),
  '--plt': (cut) => cut.hpgl(),
  '--map': (cut) => `${JSON.stringify(cut.map)}\n`,
};

const grammar = {
  files: ['the result file'],
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
    ],
    ...Object.keys(outputs),
  ],
  switches: ['--sew-as-1', '--guide'],
};

/** `cut`: writes cutting sheets of a result at true scale. */
export async function cut(words: readonly string[]): Promise<void> {
  const args = parseArguments(words, grammar);
  const [resultFile = ''] = args.files;
  const [printFile, colourway, garmentFile] = ['--print', '--colourway', '--garment'].map((flag) =>
    args.value(flag),
  );
  if (printFile === undefined) throw new UsageError('--print PRINT.json is missing.');
  const settings = settingsOf(args);
  const inputs = [resultFile, printFile, ...(garmentFile === undefined ? [] : [garmentFile])];
  const wanted = Object.entries(outputs).flatMap(([flag, content]) => {
    const path = args.value(flag);
    return path === undefined ? [] : [{flag, path, content}];
  });
  checkDistinct(Object.fromEntries(wanted.map(({flag, path}) => [flag, path])));
  for (const {path} of wanted) await checkWritable(path, inputs);

  const {result} = await readResult(resultFile);
  const cloth = await readFabricOf(result, resultFile, {printFile, colourway});
  const tile = await readTile(cloth, printFile);
  const garment = await garmentOf(result, garmentFile);
  if (!garment) {
    remark(
      `${resultFile} does not hold its design, so pieces have no notches and no grain lines of their own; name the garment with --garment FILE.`,
    );
  }
  const done = await cutResult(result, {
    ...settings,
    ...garment,
    ...(colourway !== undefined && {colourway}),
    print: {...cloth, ...(tile !== undefined && {tile})},
    names: chosenNames(result.design),
    plain: plainIn(result),
    pixels: () => readRaster(cloth, printFile),
    ...(result.reproduced === false && {mark: notAsSold}),
  });
  for (const {path, content} of wanted) await writeWhole(path, await content(done, args));
  print(figures(resultFile, done));
  if (wanted.length === 0) {
    remark(`Nothing was written: name a file by ${Object.keys(outputs).join(', ')}.`);
  }
}

/** @throws {UsageError} for an invalid value */
function settingsOf(args: Arguments) {
  const allowanceCm = lengthCm(args, '--allowance', greatestAllowance);
  const hemCm = lengthCm(args, '--hem', greatestAllowance);
  const paper = args.value('--paper');
  if (paper !== undefined && !paperOf(paper)) throw new UsageError(noPaper(paper));
  const ink = choice(args, '--ink', printInks);
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
    ...(day !== undefined && {date}),
  };
}

function figures(resultFile: string, {sheet, layout}: Cut): string {
  const {pieces, widthCm, heightCm} = sheet;
  const {pages, paper} = layout;
  const size = (width: number, height: number): string =>
    `${width.toFixed(1)} x ${height.toFixed(1)} cm`;
  return [
    `${resultFile}: ${pieces.length} pieces on a sheet of ${size(widthCm, heightCm)}`,
    `${pages.length} ${pages.length === 1 ? 'page' : 'pages'} of ${size(layout.widthCm, layout.heightCm)}, ${paper.name}`,
  ].join('; ');
}
