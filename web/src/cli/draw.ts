import {extname} from 'node:path';

import {chosenNames, garmentTitle, panelMarks} from '../model/garment/panel-marks.js';
import {titleOfFile} from '../model/garment/piece-names.js';
import {fieldOf} from '../model/base/read.js';
import {drawResult, type PictureOptions} from '../picture/draw-result.js';
import {notAsSold} from '../picture/watermark.js';
import {placementsIn} from '../layout/on-body.js';
import {readGarment} from '../node/index.js';
import {parseArguments, UsageError} from './base/arguments.js';
import {checkWritable, writeWhole} from './base/files.js';
import {imageTypes, readTile} from './base/print-files.js';
import {readFabricOf, readResult, type ResultFile} from './result-file.js';
import {print} from './base/terminal.js';

const grammar = {
  files: ['the result file'],
  valued: ['--print', '--colourway', '--out', '--title'],
  switches: ['--cloth-only'],
};

/** `draw`: draws a result on its print, before and after, as a self-contained SVG file. */
export async function draw(words: readonly string[]): Promise<void> {
  const args = parseArguments(words, grammar);
  const [resultFile = ''] = args.files;
  const printFile = args.value('--print');
  if (printFile === undefined) throw new UsageError('--print PRINT.json is missing.');
  const out = args.value('--out');
  const title = args.value('--title');
  const colourway = args.value('--colourway');
  const ending = extname(out ?? '').toLowerCase();
  if (ending !== '.svg' && ending in imageTypes) {
    throw new UsageError(`${out ?? ''} would hold SVG; name a file ending in .svg.`);
  }
  const {result} = await readResult(resultFile);
  const fabric = await readFabricOf(result, resultFile, {printFile, colourway});
  if (out !== undefined) await checkWritable(out, [resultFile, printFile]);
  const known = await designIn(result);
  const tile = await readTile(fabric, printFile);
  const picture = drawResult(
    result,
    {...fabric, ...(tile === undefined ? {} : {tile})},
    {
      ...known,
      title: title ?? known?.title ?? titleOfFile(resultFile),
      clothOnly: args.has('--cloth-only'),
      ...(result.reproduced === false && {mark: notAsSold}),
    },
  );
  if (out === undefined) print(picture);
  else await writeWhole(out, picture);
}

/** Garment title and piece data from the result's design; undefined without a design. */
async function designIn({
  pieces,
  design,
}: ResultFile): Promise<Pick<PictureOptions, 'title' | 'names' | 'placements'> | undefined> {
  const [text, file] = ['text', 'name'].map((key) => fieldOf(fieldOf(design, 'garment'), key));
  if (typeof text !== 'string') return undefined;
  try {
    const garment = await readGarment(text);
    const marks = panelMarks(garment, {names: chosenNames(design)});
    const {title} = garmentTitle(garment, typeof file === 'string' ? file : undefined);
    return {
      ...(title !== undefined && {title}),
      names: pieces.map(({name}) => marks.get(name)?.label ?? name),
      placements: placementsIn(marks),
    };
  } catch {
    return undefined; // the drawing does not depend on a valid garment
  }
}
