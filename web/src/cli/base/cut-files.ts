/** Writes cutting sheets of a solved garment. */
import {ruleOf} from '../../cutting/allowance-rule.js';
import {cutSheet, type CuttingMarks} from '../../cutting/lay-sheet.js';
import {garmentTitle, panelMarks, type PanelDecisions} from '../../model/garment/panel-marks.js';
import {asCut} from '../../model/print/as-cut.js';
import type {Print} from '../../model/print/repeating-print.js';
import type {SolveResult} from '../../model/result/result.js';
import {addressFrom, readAddress, type ReadingLimits} from '../../node/addresses.js';
import {readGarment} from '../../node/index.js';
import {lettersFrom} from '../../node/letters.js';
import type {PrintInk} from '../../cutting/print-ink.js';
import {cutFile, type CutFileKind} from '../../paper/cut-file.js';
import {fetchTile} from './print-files.js';

/** Settings of the cutting sheets. Lengths in cm. */
export interface CutWish {
  /** Paper of a PDF. Default a4. */
  readonly paper?: string;
  /** Seam allowance. Default 1. */
  readonly allowance?: number;
  /** Hem allowance. Default: the seam allowance if stated, otherwise 3. */
  readonly hem?: number;
  /** Default full. */
  readonly ink?: PrintInk;
  /** Adds a placing guide to a PDF. Default false. */
  readonly guide?: boolean;
}

/** A result with the data of its garment file and its design. */
export interface CutAnswer {
  readonly result: SolveResult;
  readonly garment: {readonly text: string; readonly name: string; readonly size?: string};
  readonly print: Print;
  /** Address of the print file, and limits for reading the files it refers to. */
  readonly address: URL;
  readonly limits?: ReadingLimits;
  readonly decisions?: PanelDecisions;
  readonly plain?: readonly string[];
  /** Watermark on every page. */
  readonly mark?: string;
}

async function marksOf({garment: {text, name, size}, decisions}: CutAnswer): Promise<CuttingMarks> {
  const garment = await readGarment(text, name);
  return {
    ...garmentTitle(garment, name),
    ...(size !== undefined && {size}),
    panels: panelMarks(garment, decisions),
  };
}

/**
 * Writes one file of each kind.
 * @throws {UsageError} if the print's image has an unsupported format
 * @throws {FileError} if the print's image cannot be read or drawn
 */
export async function cutFiles(
  answer: CutAnswer,
  kinds: readonly CutFileKind[],
  {paper = 'a4', allowance, hem, ink = 'full', guide = false}: CutWish,
): Promise<readonly (string | Uint8Array)[]> {
  const {result, address, limits = {}, plain = [], mark} = answer;
  const tile = await fetchTile(answer.print, address, limits);
  const print = asCut({...answer.print, ...(tile !== undefined && {tile})});
  const sheet = cutSheet(result, answer.print, await marksOf(answer), {
    ...ruleOf({allowanceCm: allowance, hemCm: hem}),
    ...{units: 'cm', plain},
  });
  const raster = print.colourways?.find(({image}) => image === print.image)?.raster;
  const pixels = async (): Promise<Uint8Array<ArrayBuffer> | undefined> =>
    raster === undefined
      ? undefined
      : new Uint8Array(await readAddress(addressFrom(address, raster), limits));
  const units = {units: 'cm'} as const;
  const options = {
    paper,
    ink,
    pixels,
    letters: lettersFrom(),
    ...(guide && {guide: units}),
    ...(mark !== undefined && {mark}),
  };
  return Promise.all(kinds.map((file) => cutFile(sheet, print, {file, ...options})));
}
