/** Writes a cutting sheet as a file of any kind. */
import {SolverError} from '../model/base/failure.js';
import type {CutSheet} from '../cutting/cut-sheet.js';
import {drawSheetSvg} from '../cutting/draw-sheet-svg.js';
import type {DxfFormat} from '../model/base/dxf-format.js';
import {sheetDxf} from '../cutting/out/sheet-dxf.js';
import {sheetHpgl} from '../cutting/out/sheet-hpgl.js';
import type {PrintWithTile} from '../picture/fabric.js';
import {cuttingPdf, type CuttingPdfOptions} from './cutting-pdf.js';
import {noPaper, paperOf} from './papers.js';

export type CutFileKind = 'pdf' | 'svg' | 'dxf' | 'plt';

interface CutFileOptions extends Omit<CuttingPdfOptions, 'paper'> {
  readonly file: CutFileKind;
  /** Paper of a PDF: a name or a size, as in `paperOf`. */
  readonly paper: string;
  /** Dialect and unit of a DXF file. */
  readonly dxf?: DxfFormat;
}

/**
 * Writes a cutting sheet. Files for cutters and plotters contain no print.
 * @throws {SolverError} `options` for an unknown paper
 * @throws {FileError} if the print's image cannot be drawn
 */
export async function cutFile(
  sheet: CutSheet,
  print: PrintWithTile,
  {file, paper: word, dxf, ...options}: CutFileOptions,
): Promise<string | Uint8Array<ArrayBuffer>> {
  switch (file) {
    case 'svg':
      return drawSheetSvg(sheet, print, options);
    case 'dxf':
      return sheetDxf(sheet, {
        ...dxf,
        ...(options.date && {date: options.date}),
        ...(options.mark !== undefined && {mark: options.mark}),
      });
    case 'plt':
      return sheetHpgl(sheet, options.mark);
    default: {
      const paper = paperOf(word);
      if (!paper) throw new SolverError({code: 'options', message: noPaper(word)});
      return (await cuttingPdf(sheet, print, {...options, paper})).bytes;
    }
  }
}
