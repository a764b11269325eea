/** Writes a layout as PDF: reduced on pages of paper, or at true scale for a plotter. */
import {cornersOf, boxAt} from '../../paper/boxes.js';
import {fabricUnder, type Cell} from '../../paper/cell.js';
import {fabricCell, type CellPixels} from '../../paper/fabric-cell.js';
import {drawMarks} from '../../paper/draw-marks.js';
import type {Paper} from '../../paper/papers.js';
import {filledWith, line, onLayer, pointsPerCm, scoped, through} from '../../files/pdf/content.js';
import {PdfDocument} from '../../files/pdf/document.js';
import {missingNotes, pdfFile} from '../../files/pdf/file.js';
import {PdfResources} from '../../files/pdf/resources.js';
import type {OtherLetters} from '../../files/pdf/fonts/other-letters.js';
import {textAt} from '../../files/pdf/text.js';
import type {Point} from '../../model/geometry/vectors.js';
import type {LayPlan} from '../../model/result/marker-plan.js';
import type {PrintWithTile} from '../../picture/fabric.js';
import type {SheetFormat} from './plan-style.js';
import {printOnFabric} from './plan-pieces.js';
import {leastWidth, planSheets, type PlanOptions, type PlanSheet} from './plan-sheets.js';
import {plan as english} from '../../texts/en/plan.js';
import {veils} from './veils.js';

interface PlanPdfOptions extends PlanOptions {
  /** Print whose tile is drawn faintly below the pieces. */
  readonly print: PrintWithTile;
  /**
   * 1 for a plotter, on a page as wide as the fabric; 10 for paper, reduced further if the fabric
   * is too wide.
   */
  readonly scale: 10 | 1;
  /** Paper of a reduced layout. Default A4. */
  readonly paper?: Paper;
  /** Creation date. Without it, the same layout gives the same bytes. */
  readonly date?: Date;
  readonly pixels?: CellPixels;
  /** Letters that the embedded font does not have. */
  readonly letters?: OtherLetters;
}

export interface PlanPdf {
  readonly bytes: Uint8Array<ArrayBuffer>;
  readonly pages: number;
  /** One sentence each. */
  readonly notes: readonly string[];
}

const a4: Paper = {name: 'A4', widthCm: 21, heightCm: 29.7};
/** [cm on paper] */
const margin = 1;
const footSize = 0.26;
const footRise = 0.5;
/** Greatest page height that PDF viewers display. [cm] */
const longest = 500;

const layerNames = {
  ...{print: 'Print', cut: 'Cut line', sew: 'Sew line', marks: 'Marks', matches: 'Match points'},
  words: 'Words',
};

type Layers = Readonly<Record<keyof typeof layerNames, string>>;

/** Portrait if the fabric fits, otherwise landscape, otherwise a smaller scale. */
function formatOn({widthCm, heightCm = longest}: Paper, plan: LayPlan, scale: number): SheetFormat {
  const needed = leastWidth(plan, scale) + 2 * margin;
  const [narrow, wide] = [Math.min(widthCm, heightCm), Math.max(widthCm, heightCm)];
  const width = needed <= narrow + 1e-9 ? narrow : wide;
  // text has the same size at any scale, so the recursion ends once only the text is too wide
  if (needed > wide && leastWidth(plan, 2 * scale) < leastWidth(plan, scale)) {
    return formatOn({name: '', widthCm, heightCm}, plan, 2 * scale);
  }
  return {
    ...{scale, isAsHighAsNeeded: false, isRoll: false, marginCm: margin * scale},
    ...{widthCm: width * scale, heightCm: (width === narrow ? wide : narrow) * scale},
  };
}

const roll = ({widthCm}: LayPlan): SheetFormat => ({
  ...{scale: 1, isAsHighAsNeeded: true, isRoll: true, marginCm: 0},
  ...{widthCm, heightCm: longest},
});

const white = filledWith([1, 1, 1]);

function drawnFabric(
  plan: LayPlan,
  {from, to, at, marks, holes}: NonNullable<PlanSheet['fabric']>,
  resources: PdfResources,
  {layers, cell}: {readonly layers: Layers; readonly cell: Cell | undefined},
): string {
  const window = boxAt([0, from], plan.widthCm, to - from);
  // edge lines of the fabric extend beyond it, so the clip box is wider there
  const [first, last] = [from > 0 ? from : -1, to < plan.lengthCm ? to : to + 1];
  const clip = boxAt([-1, first], plan.widthCm + 2, last - first);
  const {around, outside, inside} = veils(plan, {from, to}, holes);
  const fabric = {
    ...{cut: [around], place: printOnFabric([0, 0])},
    ...(plan.printOrigin && {alignment: printOnFabric(plan.printOrigin)}),
  };
  const veil = (loops: readonly (readonly Point[])[], opacity: number): string =>
    scoped(
      `/${resources.opacity(opacity)} gs`,
      white,
      ...loops.map((loop) => line(loop, true)),
      'f*',
    );
  return scoped(
    through({xx: 1, xy: 0, yx: 0, yy: 1, shift: at}),
    `${line(cornersOf(clip), true)}\nW n`,
    scoped(
      `${line(around, true)}\nW n`,
      onLayer(
        layers.print,
        cell ? fabricUnder(resources, cell, fabric, {window}) : '',
        veil(outside.loops, outside.opacity),
        veil(inside.loops, inside.opacity),
      ),
    ),
    drawMarks(marks, window, layers, resources),
  );
}

/**
 * Writes the layout.
 * @throws {FileError} if the print's tile cannot be drawn
 */
export async function planPdf(
  plan: LayPlan,
  {print, scale, paper = a4, date, pixels, letters, ...options}: PlanPdfOptions,
): Promise<PlanPdf> {
  const notes: string[] = [];
  const format = scale === 1 ? roll(plan) : formatOn(paper, plan, scale);
  const sheets = planSheets(plan, print, options, format);
  const document = new PdfDocument();
  const resources = new PdfResources(document);
  const layer = (name: keyof typeof layerNames): string => resources.layer(layerNames[name]);
  const layers: Layers = {
    ...{print: layer('print'), cut: layer('cut'), marks: layer('marks')},
    ...{matches: layer('matches'), words: layer('words'), sew: layer('sew')},
  };
  const cell = plan.printOrigin
    ? await fabricCell(resources, print, pixels, (sentence) => notes.push(sentence))
    : undefined;
  const {texts = english} = options.words;
  const toPoints = pointsPerCm / format.scale;
  const pages = sheets.map(({widthCm, heightCm, marks, fabric}, k) => {
    const foot = textAt(
      resources,
      [widthCm - format.marginCm, footRise * format.scale],
      texts.page(k + 1, sheets.length),
      {size: footSize * format.scale, align: 'right'},
    );
    return {
      ...{widthCm: widthCm / format.scale, heightCm: heightCm / format.scale, label: String(k + 1)},
      content: () =>
        scoped(
          through({xx: toPoints, xy: 0, yx: 0, yy: toPoints, shift: [0, 0]}),
          fabric ? drawnFabric(plan, fabric, resources, {layers, cell}) : '',
          drawMarks(marks, boxAt([0, 0], widthCm, heightCm), layers, resources),
          format.isRoll || sheets.length === 1 ? '' : onLayer(layers.words, foot),
        ),
    };
  });
  const {bytes, missing} = await pdfFile(document, resources, pages, {
    ...{title: options.title ?? texts.title(format.scale), mode: 'UseNone'},
    ...(date && {date}),
    ...(letters && {letters}),
    ...(options.words.locale !== undefined && {locale: options.words.locale}),
  });
  return {bytes, pages: sheets.length, notes: [...notes, ...missingNotes(missing)]};
}
