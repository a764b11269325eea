import {extname} from 'node:path';

import {blobOf} from '../image/data-url.js';
import type {PhotoPixels} from '../model/print/photo-reading.js';
import {asVariant, mostTurn} from '../model/print/print-variant.js';
import {dpiLimits, scaleLimits} from '../model/print/print-scale.js';
import {readPrintFile} from '../model/print/read-print-file.js';
import type {Print} from '../model/print/repeating-print.js';
import {textOf} from '../node/files.js';
import {printRepeat} from '../node/index.js';
import {pictureIn} from '../node/picture-files.js';
import {factor, parseArguments, printTurns, UsageError, wholeNumber} from './base/arguments.js';
import {checkWritable, writeWhole} from './base/files.js';
import {inColourway, readPrint, readRaster, readTile} from './base/print-files.js';
import {print, remark} from './base/terminal.js';

const grammar = {
  files: [],
  valued: ['--print', '--colourway', '--size', '--turn', '--dpi', '--out'],
  switches: [],
};

const usualDpi = 300;

/** `repeat`: writes the rectangular repeat of a print for a print shop. */
export async function repeat(words: readonly string[]): Promise<void> {
  const args = parseArguments(words, grammar);
  const [printFile, out] = [args.value('--print'), args.value('--out')];
  if (printFile === undefined) throw new UsageError('--print PRINT.json is missing.');
  if (out === undefined) throw new UsageError('--out FILE.png or FILE.svg is missing.');
  const ending = extname(out).toLowerCase();
  if (ending !== '.png' && ending !== '.svg') {
    throw new UsageError(
      `${out} is no kind of file for a repeat; name one ending in .png or .svg.`,
    );
  }
  const dpi = wholeNumber(args, '--dpi', dpiLimits) ?? usualDpi;
  const scale = factor(args, '--size', scaleLimits) ?? 1;
  const turnDeg = printTurns(args, '--turn', mostTurn) ?? 0;
  if (typeof turnDeg !== 'number') throw new UsageError('--turn takes one number of degrees.');
  await checkWritable(out, [printFile]);
  const own = readPrintFile(textOf(await readPrint(printFile)), printFile);
  const colourway = args.value('--colourway');
  const shown = colourway === undefined ? own : inColourway(own, colourway, printFile);
  const fabric = asVariant(shown, {scale, turnDeg});
  const tile = await readTile(fabric, printFile);
  const made = await printRepeat({...fabric, ...(tile !== undefined && {tile})});
  const size = made.rectangle
    ? `${made.rectangle.width.toFixed(2)} x ${made.rectangle.height.toFixed(2)} cm`
    : 'no upright rectangle tiles this print; its cell is an SVG pattern';
  if (ending === '.svg') {
    await writeWhole(out, made.svg());
    print(`${out}: ${size}`);
    return;
  }
  const {bytes, width, height, imageDpi} = await made.png(
    () => cellOf(fabric, printFile, tile),
    dpi,
  );
  await writeWhole(out, bytes);
  print(`${out}: ${size}, ${String(width)} x ${String(height)} pixels, ${String(dpi)} dpi`);
  if (imageDpi < 0.9 * dpi) {
    remark(
      `The image of the print has ${String(Math.round(imageDpi))} dpi at this size; the picture is no sharper.`,
    );
  }
}

/**
 * The image of the cell as pixels.
 * @throws {UsageError} for an image that Node cannot draw
 */
async function cellOf(
  fabric: Print,
  printFile: string,
  tile: string | undefined,
): Promise<PhotoPixels> {
  if (tile?.startsWith('data:') && !tile.startsWith('data:image/svg')) {
    const bytes = new Uint8Array(await blobOf(tile).arrayBuffer());
    return (await pictureIn(bytes, printFile)).pixels;
  }
  const raster = await readRaster(fabric, printFile);
  if (raster) return (await pictureIn(raster, printFile)).pixels;
  throw new UsageError(
    tile === undefined
      ? `${printFile} has no image; add the image of a cell.`
      : `The image of ${printFile} is SVG, which this command cannot draw; write .svg, or save PNG from the page.`,
  );
}
