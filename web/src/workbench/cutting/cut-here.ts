/** Makes cutting sheets on the calling thread. */
import {cutSheet} from '../../cutting/lay-sheet.js';
import type {AllowanceRule} from '../../cutting/allowances.js';
import {cutFile, type CutFileKind} from '../../paper/cut-file.js';
import type {Workbench} from '../workbench.js';
import {pixelsOfTile} from '../../image/embedded-tile.js';
import {cutMaterial} from './cut-material.js';

interface CutRequest extends AllowanceRule {
  readonly file: CutFileKind;
  readonly paper: string;
  readonly ink: 'full' | 'outline';
}

/**
 * Returns a cutting sheet; undefined before there is a result.
 * @throws {RangeError} for an unknown paper size; {Error} if the print's image cannot be read
 */
export async function cutHere(
  workbench: Workbench,
  {file, paper, ink, ...rule}: CutRequest,
): Promise<string | Uint8Array<ArrayBuffer> | undefined> {
  const material = await cutMaterial(workbench, rule);
  if (!material) return undefined;
  const {result, print, marks, options} = material;
  const sheet = cutSheet(result, print, marks, options);
  const pixels = (width: number, height: number) => pixelsOfTile(print.tile ?? '', width, height);
  return cutFile(sheet, print, {file, paper, ink, pixels});
}
