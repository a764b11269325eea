import {decidedOf} from '../model/design/design.js';
import {packageVersion} from '../model/base/version.js';
import {addressFrom, addressOf, folderOf, readAddress} from '../node/addresses.js';
import {textOf} from '../node/files.js';
import {order as solveOrder, orderRecord, readGarment, type Order} from '../node/index.js';
import {greatestAllowance} from '../cutting/allowance-rule.js';
import {noPaper, paperOf} from '../paper/papers.js';
import {printInks} from '../cutting/print-ink.js';
import type {MarkerSettings} from '../marker/settings.js';
import {notAsSold} from '../picture/watermark.js';
import {choice, lengthCm, parseArguments, UsageError, type Arguments} from './base/arguments.js';
import {cutFiles, type CutAnswer, type CutWish} from './base/cut-files.js';
import {layRange} from './base/lay-wish.js';
import {fetchTile} from './base/print-files.js';
import {figuresLine} from './figures.js';
import {checkDistinct, checkWritable, writeWhole} from './base/files.js';
import {print, ProgressLine, remark} from './base/terminal.js';

/** Cutting-sheet formats by flag. */
const cutFlags = {'--svg': 'svg', '--pdf': 'pdf', '--dxf': 'dxf', '--plt': 'plt'} as const;
const wishFlags = ['--paper', '--allowance', '--hem', '--ink'];

const grammar = {
  files: ['the design file'],
  valued: [
    ...['--base', '--out', '--record', '--width', '--selvedge'],
    ...[...Object.keys(cutFlags), ...wishFlags],
  ],
  switches: ['--json', '--guide'],
};

/** Exit code for scripts if the written answer differs from the sold one. */
const notReproducedCode = 3;

/**
 * `order`: solves a stored design again for production, and reports whether the answer equals the
 * sold one.
 */
export async function order(words: readonly string[]): Promise<void> {
  const args = parseArguments(words, grammar);
  const [designFile = ''] = args.files;
  const [outFile, baseWord, recordFile] = ['--out', '--base', '--record'].map((flag) =>
    args.value(flag),
  );
  const cuts = Object.entries(cutFlags).flatMap(([flag, kind]) => {
    const file = args.value(flag);
    return file === undefined ? [] : [{flag, kind, file}];
  });
  const wish = wishOf(args);
  const cloth = clothOf(args, recordFile);
  const idle = wishFlags.find((flag) => args.value(flag) !== undefined);
  if (cuts.length === 0 && idle !== undefined) {
    throw new UsageError(
      `${idle} belongs to --pdf FILE.pdf, --svg, --dxf or --plt, which is missing.`,
    );
  }
  checkDistinct({
    ...{'--out': outFile, '--record': recordFile},
    ...Object.fromEntries(cuts.map(({flag, file}) => [flag, file])),
  });
  for (const file of [outFile, recordFile, ...cuts.map(({file}) => file)]) {
    if (file !== undefined) await checkWritable(file, [designFile]);
  }
  const address = addressOf(designFile);
  const base = baseWord === undefined ? new URL('.', address) : folderOf(baseWord);
  // a foreign design must not read files outside these folders
  const within =
    baseWord === undefined && base.protocol === 'file:' ? [base, folderOf('.')] : [base];
  const stored = textOf(await readAddress(address));

  const progress = new ProgressLine();
  let done: Order;
  try {
    done = await solveOrder(stored, {
      ...{base, within, name: designFile, ...(cloth && {cloth})},
      onProgress: (step) => {
        progress.show(step);
      },
    });
  } finally {
    progress.clear();
  }
  if (cuts.length > 0) {
    const kinds = cuts.map(({kind}) => kind);
    const contents = await cutFiles(answerOf(done, {base, within}), kinds, wish);
    for (const [k, {file}] of cuts.entries()) await writeWhole(file, contents[k] ?? '');
  }
  if (outFile !== undefined) await writeWhole(outFile, done.text);
  if (recordFile !== undefined) {
    const address = addressFrom(base, done.design.print.url);
    const tile = await fetchTile(done.print, address, {within});
    const record = await orderRecord(done, {...(tile !== undefined && {tile})});
    await writeWhole(recordFile, `${JSON.stringify(record, null, 2)}\n`);
  }
  await report(designFile, done, args.has('--json'));
  if (!done.reproduced) process.exitCode = notReproducedCode;
}

/**
 * The fabric of the record.
 * @throws {UsageError} for an invalid length, and for a width without a record
 */
function clothOf(args: Arguments, recordFile: string | undefined): MarkerSettings | undefined {
  const [widthCm, selvedgeCm] = ['--width', '--selvedge'].map((flag) =>
    lengthCm(args, flag, layRange('width')[1]),
  );
  if (widthCm === undefined) {
    if (selvedgeCm === undefined) return undefined;
    throw new UsageError('--selvedge belongs to --width CM, which is missing.');
  }
  if (recordFile === undefined) {
    throw new UsageError('--width belongs to --record FILE.json, which is missing.');
  }
  return {widthCm, ...(selvedgeCm !== undefined && {selvedgeCm})};
}

/** @throws {UsageError} for an invalid value */
function wishOf(args: Arguments): CutWish {
  const [allowance, hem] = ['--allowance', '--hem'].map((flag) =>
    lengthCm(args, flag, greatestAllowance),
  );
  const paper = args.value('--paper');
  if (paper !== undefined && !paperOf(paper)) throw new UsageError(noPaper(paper));
  const ink = choice(args, '--ink', printInks);
  return {
    ...(paper !== undefined && {paper}),
    ...(allowance !== undefined && {allowance}),
    ...(hem !== undefined && {hem}),
    ...(ink && {ink}),
    ...(args.has('--guide') && {guide: true}),
  };
}

function answerOf(
  {design, garment: text, print, result, reproduced}: Order,
  {base, within}: {readonly base: URL; readonly within: readonly URL[]},
): CutAnswer {
  const {url, size} = design.garment;
  return {
    ...{result, print, address: addressFrom(base, design.print.url), limits: {within}},
    garment: {
      ...{text, name: new URL(addressFrom(base, url)).pathname},
      ...(size !== undefined && {size}),
    },
    decisions: decidedOf(design),
    plain: design.options.plain ?? [],
    ...(!reproduced && {mark: notAsSold}),
  };
}

async function report(designFile: string, done: Order, asJson: boolean): Promise<void> {
  const {design, garment, result, reproduced, differenceCm} = done;
  if (asJson) {
    print(
      JSON.stringify({
        design: designFile,
        reproduced,
        ...{differenceCm, soldWith: design.solver, solver: packageVersion},
        group: result.print.group,
        ...result.metrics,
        notes: result.notes,
      }),
    );
  } else {
    result.notes.forEach(remark);
    const read = await readGarment(garment, design.garment.url);
    const asked = {garment: read, options: design.options};
    print(`${figuresLine(designFile, result, asked)}; reproduced ${String(reproduced)}`);
  }
  if (!reproduced) remark(difference(designFile, done));
}

function difference(designFile: string, {design, differenceCm}: Order): string {
  const where =
    differenceCm === null
      ? 'and its alignments are of other pieces'
      : `and the print lies up to ${differenceCm.toFixed(3)} cm from where it was sold`;
  const remedy =
    design.solver === packageVersion
      ? `it was sold with this version, ${packageVersion}, so check that nobody changed the design or the solver's module`
      : `for the very answer that was sold, keep version ${design.solver} beside this one (npm install seamwise-${design.solver}@file:seamwise-${design.solver}.tgz) and order with that: node node_modules/seamwise-${design.solver}/dist/cli/main.js order ${designFile}`;
  return `the answer differs from the one that was sold, ${where}; ${remedy}.`;
}
