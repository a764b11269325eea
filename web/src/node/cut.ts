/** Pieces of a result to cut: a sheet, and files of it. */
import type {CutSheet} from '../cutting/cut-sheet.js';
import {sheetsOf} from '../cutting/lay-sheet.js';
import {drawSheetSvg} from '../cutting/draw-sheet-svg.js';
import {sheetDxf, type DxfOptions} from '../cutting/out/sheet-dxf.js';
import {sheetHpgl} from '../cutting/out/sheet-hpgl.js';
import type {GarmentDocument} from '../model/garment-document.js';
import {garmentTitle, panelMarks, type PanelDecisions} from '../model/garment-marks.js';
import type {SolveResult} from '../model/result.js';
import type {CellPixels} from '../paper/cloth-cell.js';
import {cuttingPdf, pagesOf, sheetFor, type CuttingPdf} from '../paper/cutting-pdf.js';
import {noPaper, paperOf} from '../paper/papers.js';
import type {PageLayout} from '../paper/pages.js';
import {sheetMap, type SheetMap} from '../paper/sheet-map.js';
import type {PrintWithTile} from '../picture/cloth.js';

export interface CutSettings extends PanelDecisions {
  /** The print that the result was solved with; `tile` is the picture of its cell, as SVG text or `data:` URL. */
  readonly print: PrintWithTile;
  /** What the garment's file says of its pieces: names, notches, grain lines, and where they are worn. */
  readonly garment?: GarmentDocument;
  /** What the garment is called where its file gives no title. */
  readonly garmentFile?: string;
  /** Around the pieces, where the garment gives an edge none of its own. Default 1. [cm] */
  readonly allowanceCm?: number;
  /** Of hems, where the garment gives them none. Default `allowanceCm` if that is given, else 3. [cm] */
  readonly hemCm?: number;
  /** Of the print, as it is called. */
  readonly colourway?: string;
  /** Pieces, by name, that are cut from unprinted cloth. */
  readonly plain?: readonly string[];
  /** a4, letter, a3, legal, tabloid, a2, a1, a0, 36in, projector, or a size, such as 60x90. Default a4. */
  readonly paper?: string;
  /** The print in its place, or lines alone. Default full. */
  readonly ink?: 'full' | 'outline';
  /** Stands on every page. */
  readonly date?: Date;
  /** Words across every page. */
  readonly mark?: string;
  /** The cell as PNG or JPEG, asked for where `tile` is none and no simple SVG. */
  readonly pixels?: CellPixels;
}

export interface Cut {
  readonly sheet: CutSheet;
  /** The pages that `pdf` will have. */
  readonly layout: PageLayout;
  readonly map: SheetMap;
  /** @throws {FileError} where the print's picture can be drawn by nobody */
  readonly pdf: () => Promise<Pick<CuttingPdf, 'bytes' | 'notes'>>;
  /** All on one sheet, at true scale. */
  readonly svg: () => string;
  /** For programs and machines that cut: AAMA DXF, and HP-GL. */
  readonly dxf: (options?: DxfOptions) => string;
  readonly hpgl: () => string;
}

/** [cm] */
const usualAllowance = 1;
const usualHem = 3;

/** @throws {RangeError} for a paper that is none */
export function cutWith(result: SolveResult, settings: CutSettings): Cut {
  const {print, garment, garmentFile, plain = [], mark} = settings;
  const {allowanceCm = usualAllowance, hemCm = settings.allowanceCm ?? usualHem} = settings;
  const {paper: word = 'a4', ink, date, pixels, colourway} = settings;
  const paper = paperOf(word);
  if (!paper) throw new RangeError(noPaper(word));
  const marks = {
    ...(garment && garmentTitle(garment, garmentFile)),
    panels: garment ? panelMarks(garment, settings) : new Map(),
  };
  const sheetAt = sheetsOf(result, print, marks, {
    ...{allowanceCm, hemCm, plain, units: 'cm'},
    ...(colourway !== undefined && {colourway}),
    ...(date && {date: date.toISOString().slice(0, 10)}),
  });
  const sheet = sheetFor(paper, sheetAt);
  const layout = pagesOf(sheet, paper);
  return {
    ...{sheet, layout, map: sheetMap(sheet, layout)},
    pdf: () =>
      cuttingPdf(sheet, print, {
        paper,
        ...(ink && {ink}),
        ...(date && {date}),
        ...(mark !== undefined && {mark}),
        ...(pixels && {pixels}),
      }),
    svg: () => drawSheetSvg(sheet, print, mark),
    dxf: (options) => sheetDxf(sheet, {...(date && {date}), ...options}),
    hpgl: () => sheetHpgl(sheet),
  };
}
