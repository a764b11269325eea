/** Input of a cutting sheet, available after a solve. */
import {decidedOf, noPicture, printOf} from '../../model/design/design.js';
import {SolverError} from '../../model/base/failure.js';
import {garmentTitle, panelMarks} from '../../model/garment/panel-marks.js';
import {asCut} from '../../model/print/as-cut.js';
import type {SolveResult} from '../../model/result/result.js';
import type {AllowanceRule} from '../../cutting/allowance-rule.js';
import type {PrintInk} from '../../cutting/print-ink.js';
import type {DxfFormat} from '../../model/base/dxf-format.js';
import {cutSheet, type CuttingMarks, type SheetOptions} from '../../cutting/lay-sheet.js';
import type {PrintWithTile} from '../../picture/fabric.js';
import {printName, withSampleNames} from '../../texts/sample-names.js';
import type {Workbench} from '../workbench.js';
import {embeddedTile, pixelsOfTile} from '../../image/embedded-tile.js';
import {cutFile, type CutFileKind} from '../../paper/cut-file.js';
import {drawnLetters} from './drawn-letters.js';

/** Plain data, which can be posted to a worker. */
export interface CutMaterial {
  readonly result: SolveResult;
  /** The print after the wash of its fabric. */
  readonly print: PrintWithTile;
  readonly marks: CuttingMarks;
  readonly options: SheetOptions;
}

/**
 * Returns the input; undefined before there is a result.
 * @throws {SolverError} `unscaled`; {Error} if the print's image cannot be read
 */
export async function cutMaterial(
  {history: {design}, solving: {garment, result}, preferences}: Workbench,
  rule: AllowanceRule,
): Promise<CutMaterial | undefined> {
  if (!design || !garment || !result) return undefined;
  const {units, language: locale} = preferences.chosen;
  const {texts} = preferences;
  if (design.print.unscaled) {
    const message = texts.print.unscaled;
    throw new SolverError({code: 'unscaled', message});
  }
  const {image} = design.print;
  const tile = image === noPicture ? undefined : await embeddedTile(image);
  const named = withSampleNames(garment, design.garment.name, texts);
  return {
    result,
    print: {
      ...{...printOf(design.print), title: printName(design.print, texts)},
      ...(tile !== undefined && {tile}),
    },
    marks: {
      ...garmentTitle(named, design.garment.name),
      panels: panelMarks(named, decidedOf(design)),
    },
    options: {...rule, units, locale, plain: design.options.plain ?? []},
  };
}

/** Makes cutting sheets on the calling thread. */
interface CutRequest extends AllowanceRule {
  readonly file: CutFileKind;
  readonly paper: string;
  readonly ink: PrintInk;
  readonly guide: boolean;
  readonly dxf: DxfFormat;
}

/**
 * Returns a cutting sheet; undefined before there is a result.
 * @throws {SolverError} `options` for an unknown paper size; {Error} if the print's image cannot be read
 */
export async function cutHere(
  workbench: Workbench,
  {file, paper, ink, guide, dxf, ...rule}: CutRequest,
): Promise<string | Uint8Array<ArrayBuffer> | undefined> {
  const material = await cutMaterial(workbench, rule);
  if (!material) return undefined;
  const {result, print, marks, options} = material;
  const sheet = cutSheet(result, print, marks, options);
  const pixels = (width: number, height: number) => pixelsOfTile(print.tile ?? '', width, height);
  return cutFile(sheet, asCut(print), {
    ...{file, paper, ink, dxf, pixels, letters: drawnLetters},
    ...(guide && {guide: options}),
  });
}
