import {decidedOf} from '../model/design.js';
import {garmentTitle, panelMarks} from '../model/garment-marks.js';
import {packageVersion} from '../model/version.js';
import {addressFrom, addressOf, folderOf, readAddress} from '../node/addresses.js';
import {textOf} from '../node/files.js';
import {order as solveOrder, readGarment, type Order} from '../node/index.js';
import {cuttingFile} from '../cutting/cutting-file.js';
import {notAsSold} from '../picture/mark.js';
import {lengthCm, parseArguments, UsageError} from './base/arguments.js';
import {figuresLine} from './figures.js';
import {checkDistinct, checkWritable, writeWhole} from './base/files.js';
import {fetchTile} from './print-files.js';
import {print, ProgressLine, remark} from './base/terminal.js';

const grammar = {
  files: ['the design file'],
  valued: ['--base', '--out', '--svg', '--allowance'],
  switches: ['--json'],
};

/** What the page adds unless told otherwise, and more than anybody sews with. [cm] */
const usualAllowance = 1;
const greatestAllowance = 10;
/** For scripts: what was written is an answer, but not the one that was sold. */
const notReproducedCode = 3;

/** `order`: solves a stored design again, for production, and says whether the answer is the one that was sold. */
export async function order(words: readonly string[]): Promise<void> {
  const args = parseArguments(words, grammar);
  const [designFile = ''] = args.files;
  const allowanceCm = lengthCm(args, '--allowance', greatestAllowance) ?? usualAllowance;
  const [outFile, cutFile, baseWord] = ['--out', '--svg', '--base'].map((flag) => args.value(flag));
  if (cutFile === undefined && args.value('--allowance') !== undefined) {
    throw new UsageError('--allowance belongs to --svg FILE.svg, which is missing.');
  }
  checkDistinct({'--out': outFile, '--svg': cutFile});
  for (const file of [outFile, cutFile]) {
    if (file !== undefined) await checkWritable(file, [designFile]);
  }
  const address = addressOf(designFile);
  const base = baseWord === undefined ? new URL('.', address) : folderOf(baseWord);
  // what a stranger's design names elsewhere is not read
  const within =
    baseWord === undefined && base.protocol === 'file:' ? [base, folderOf('.')] : [base];
  const stored = textOf(await readAddress(address));

  const progress = new ProgressLine();
  let done: Order;
  try {
    done = await solveOrder(stored, {
      ...{base, within, name: designFile},
      onProgress: (step) => {
        progress.show(step);
      },
    });
  } finally {
    progress.clear();
  }
  if (cutFile !== undefined)
    await writeWhole(cutFile, await toCut(done, {base, within}, allowanceCm));
  if (outFile !== undefined) await writeWhole(outFile, done.text);
  await report(designFile, done, args.has('--json'));
  if (!done.reproduced) process.exitCode = notReproducedCode;
}

async function toCut(
  {design, garment: text, print: cloth, result, reproduced}: Order,
  {base, within}: {readonly base: URL; readonly within: readonly URL[]},
  allowanceCm: number,
): Promise<string> {
  const garment = await readGarment(text, design.garment.url);
  const tile = await fetchTile(cloth, addressFrom(base, design.print.url), {within});
  const {size} = design.garment;
  return cuttingFile(
    result,
    {...cloth, ...(tile !== undefined && {tile})},
    {
      ...garmentTitle(garment, new URL(addressFrom(base, design.garment.url)).pathname),
      ...(size !== undefined && {size}),
      panels: panelMarks(garment, decidedOf(design)),
    },
    {
      ...{allowanceCm, units: 'cm', plain: design.options.plain ?? []},
      ...(!reproduced && {mark: notAsSold}),
    },
  );
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
