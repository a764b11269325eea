/** Cutting sheets of a result, and their files. */
import {checkArguments} from '../model/base/arguments.js';
import {SolverError} from '../model/base/failure.js';
import {dxfOptions, otherSizes as sizesCheck} from './setting-checks.js';
import {ruleOf} from '../cutting/allowance-rule.js';
import type {CutSheet} from '../cutting/cut-sheet.js';
import type {PrintInk} from '../cutting/print-ink.js';
import {sheetsOf} from '../cutting/lay-sheet.js';
import {drawSheetSvg} from '../cutting/draw-sheet-svg.js';
import {sheetDxf, type DxfOptions} from '../cutting/out/sheet-dxf.js';
import {sheetHpgl} from '../cutting/out/sheet-hpgl.js';
import type {GarmentDocument} from '../model/garment/garment-document.js';
import {garmentTitle, panelMarks, type PanelDecisions} from '../model/garment/panel-marks.js';
import {asCut} from '../model/print/as-cut.js';
import {fabricConflict, printOfResult} from '../model/result/print-of-result.js';
import type {SolveResult} from '../model/result/result.js';
import type {CellPixels} from '../paper/fabric-cell.js';
import {cuttingPdf, pagesOf, sheetFor, type CuttingPdf} from '../paper/cutting-pdf.js';
import {noPaper, paperOf} from '../paper/papers.js';
import {lettersFrom} from './letters.js';
import type {PageLayout} from '../paper/pages.js';
import type {SizeSheet} from '../paper/several-sizes.js';
import {sheetMap, type SheetMap} from '../paper/sheet-map.js';
import type {PrintWithTile} from '../picture/fabric.js';

export interface CutSettings extends PanelDecisions {
  /** The print of the result, in its size or in that of its file. `tile` is the image of its cell, as SVG text or `data:` URL. */
  readonly print: PrintWithTile;
  /** Garment file: names, notches, grain lines and placements of the pieces. */
  readonly garment?: GarmentDocument;
  /** File name, used as the garment's name if it has no title. */
  readonly garmentFile?: string;
  /** Seam allowance of edges without their own in the garment. Default 1. [cm] */
  readonly allowanceCm?: number;
  /**
   * Allowance of hems without their own in the garment. Default: `allowanceCm` if given, otherwise
   * 3. [cm]
   */
  readonly hemCm?: number;
  /** Name of the print's colourway. */
  readonly colourway?: string;
  /** Names of pieces that are cut from plain fabric. */
  readonly plain?: readonly string[];
  /**
   * a4, letter, a3, legal, tabloid, a2, a1, a0, 36in, projector, or a size such as 60x90. Default
   * a4.
   */
  readonly paper?: string;
  /** Keeps blank pages, for programs that join the pages row by row. Default false. */
  readonly blankPages?: boolean;
  /** Draws the print in place, tinted to save ink, or lines only. Default full. */
  readonly ink?: PrintInk;
  /**
   * Adds pages to the PDF that help to place the pieces on fabric that is printed already. Default
   * false.
   */
  readonly guide?: boolean;
  /** Date on every page. */
  readonly date?: Date;
  /** Warning: a watermark on every page, text on layer 15 of DXF, and labels in HP-GL. */
  readonly mark?: string;
  /**
   * Language of the texts: en, de, fr, es or it. Default en.
   */
  readonly language?: string;
  /** Places the pieces on those of a larger size, for a PDF of several sizes. */
  readonly under?: CutSheet;
  /**
   * Font files for letters of other scripts than Latin, Greek, Cyrillic and Japanese in a PDF: TTF
   * or WOFF with TrueType outlines.
   */
  readonly fonts?: readonly Uint8Array<ArrayBuffer>[];
  /** Returns the cell as PNG or JPEG, for a `tile` that is neither and no simple SVG. */
  readonly pixels?: CellPixels;
}

export interface Cut {
  readonly sheet: CutSheet;
  /** The print in the size of the result, as it measures on the fabric before a wash. */
  readonly print: PrintWithTile;
  /** The pages of `pdf`. */
  readonly layout: PageLayout;
  readonly map: SheetMap;
  /**
   * Writes the PDF. Other sizes are laid under the same sheet, and each is a layer.
   * @throws {FileError} if the print's image cannot be drawn
   */
  readonly pdf: (
    otherSizes?: readonly SizeSheet[],
  ) => Promise<Pick<CuttingPdf, 'bytes' | 'notes' | 'layout'>>;
  /** All pieces on one sheet, at true scale. */
  readonly svg: () => string;
  /** For CAD programs and cutters: AAMA or ASTM DXF. */
  readonly dxf: (options?: DxfOptions) => string;
  /**
   * For plotters; a sheet longer than 81.9 cm in frames of 80 cm.
   * @throws {SolverError} `options` if both sides of the sheet are longer than 163.8 cm
   */
  readonly hpgl: () => string;
}

const wrong = (message: string): SolverError => new SolverError({code: 'options', message});

/**
 * Lays out the cutting sheet of a result.
 * @throws {SolverError} `options` for a print that is not that of the result
 */
export function cutWith(result: SolveResult, settings: CutSettings): Cut {
  const {garment, garmentFile, plain = [], mark} = settings;
  const sewn = printOfResult(result.print, settings.print);
  if (!sewn) {
    throw wrong(
      fabricConflict(result.print, settings.print) ??
        'cut: the print has another group or repeat than that of the result; take the print that was solved.',
    );
  }
  const print = asCut(sewn);
  const {
    paper: word = 'a4',
    ink,
    guide = false,
    date,
    pixels,
    colourway,
    language,
    fonts,
  } = settings;
  const named = paperOf(word);
  if (!named) throw wrong(noPaper(word));
  const paper = {...named, keepsBlank: settings.blankPages ?? false};
  const marks = {
    ...(garment && garmentTitle(garment, garmentFile)),
    panels: garment ? panelMarks(garment, settings) : new Map(),
  };
  const sheetAt = sheetsOf(result, sewn, marks, {
    ...{...ruleOf(settings), plain, units: 'cm'},
    ...(language !== undefined && {locale: language}),
    ...(colourway !== undefined && {colourway}),
    ...(date && {date: date.toISOString().slice(0, 10)}),
  });
  const sheet = settings.under ? sheetAt(settings.under) : sheetFor(paper, sheetAt);
  const layout = pagesOf(sheet, paper);
  return {
    ...{sheet, print, layout, map: sheetMap(sheet, layout)},
    pdf: async (otherSizes = []) => {
      checkArguments('pdf', ['otherSizes', otherSizes, sizesCheck]);
      return cuttingPdf(sheet, print, {
        ...{paper, otherSizes, letters: lettersFrom(fonts)},
        ...(ink && {ink}),
        ...(guide && {guide: {units: 'cm', ...(language !== undefined && {locale: language})}}),
        ...(date && {date}),
        ...(mark !== undefined && {mark}),
        ...(pixels && {pixels}),
      });
    },
    svg: () => drawSheetSvg(sheet, print, {ink, mark}),
    dxf: (options = {}) => {
      checkArguments('dxf', ['options', options, dxfOptions]);
      return sheetDxf(sheet, {
        ...(date && {date}),
        ...(mark !== undefined && {mark}),
        ...options,
      });
    },
    hpgl: () => sheetHpgl(sheet, mark),
  };
}
