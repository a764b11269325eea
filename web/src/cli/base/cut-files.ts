/** Files to cut by, of an answer that was just solved. */
import {cutSheet, type CuttingMarks} from '../../cutting/lay-sheet.js';
import {garmentTitle, panelMarks, type PanelDecisions} from '../../model/garment-marks.js';
import type {Print} from '../../model/print.js';
import type {SolveResult} from '../../model/result.js';
import {addressFrom, readAddress, type ReadingLimits} from '../../node/addresses.js';
import {readGarment} from '../../node/index.js';
import {cutFile, type CutFileKind} from '../../paper/cut-file.js';
import {fetchTile} from './print-files.js';

/** What a maker chooses. Lengths in cm. */
export interface CutWish {
  /** Of PDF. Default a4. */
  readonly paper?: string;
  /** Default 1. */
  readonly allowance?: number;
  /** Default: as the allowance. */
  readonly hem?: number;
  /** Default full. */
  readonly ink?: 'full' | 'outline';
}

/** More than anybody sews with. [cm] */
export const greatestAllowance = 10;
const usualAllowance = 1;

/** What is cut: an answer with what its garment's file and its design say. */
export interface CutAnswer {
  readonly result: SolveResult;
  readonly garment: {readonly text: string; readonly name: string; readonly size?: string};
  readonly print: Print;
  /** Where the print's file lies, and what may be read there. */
  readonly address: URL;
  readonly limits?: ReadingLimits;
  readonly decisions?: PanelDecisions;
  readonly plain?: readonly string[];
  /** Words across every page. */
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
 * One file for each kind.
 * @throws {UsageError}, {FileError} where the print's picture cannot be read, or be drawn by nobody
 */
export async function cutFiles(
  answer: CutAnswer,
  kinds: readonly CutFileKind[],
  {paper = 'a4', allowance: allowanceCm = usualAllowance, hem, ink = 'full'}: CutWish,
): Promise<readonly (string | Uint8Array)[]> {
  const {result, address, limits = {}, plain = [], mark} = answer;
  const tile = await fetchTile(answer.print, address, limits);
  const print = {...answer.print, ...(tile !== undefined && {tile})};
  const sheet = cutSheet(result, print, await marksOf(answer), {
    ...{allowanceCm, units: 'cm', plain},
    ...(hem !== undefined && {hemCm: hem}),
  });
  const raster = print.colourways?.find(({image}) => image === print.image)?.raster;
  const pixels = async (): Promise<Uint8Array<ArrayBuffer> | undefined> =>
    raster === undefined
      ? undefined
      : new Uint8Array(await readAddress(addressFrom(address, raster), limits));
  const options = {paper, ink, pixels, ...(mark !== undefined && {mark})};
  return Promise.all(kinds.map((file) => cutFile(sheet, print, {file, ...options})));
}
