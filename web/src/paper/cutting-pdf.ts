/** Writes a cutting sheet as PDF at true scale, on pages of paper or for a projector. */
import type {CutMark, CutSheet} from '../cutting/cut-sheet.js';
import type {PrintInk} from '../cutting/print-ink.js';
import {middle} from '../model/geometry/vectors.js';
import type {Box} from '../model/geometry/polyline.js';
import type {PrintWithTile} from '../picture/fabric.js';
import {boxAt, cornersOf, grown} from './boxes.js';
import {fabricUnder, type Cell} from './cell.js';
import {fabricCell, type CellPixels} from './fabric-cell.js';
import {drawMarks} from './draw-marks.js';
import {drawFirstPage, roomOf} from './first-page.js';
import {drawFoot, drawFrame} from './page-frame.js';
import {guideCount, guidePages, type GuideOptions} from './guide-pages.js';
import {dividedAmong, usualMargin, type PageLayout, type SheetPage} from './pages.js';
import type {Paper} from './papers.js';
import {
  filledWith,
  line,
  nums,
  onLayer,
  pointsPerCm,
  scoped,
  strokedWith,
  through,
} from '../files/pdf/content.js';
import {PdfDocument} from '../files/pdf/document.js';
import {missingNotes, pdfFile} from '../files/pdf/file.js';
import {PdfResources} from '../files/pdf/resources.js';
import type {OtherLetters} from '../files/pdf/fonts/other-letters.js';
import {textAt, widthOf} from '../files/pdf/text.js';
import {printTitle} from '../cutting/words.js';
import {sheetTextsIn, type SheetTexts} from '../texts/sheet-texts.js';
import {sheetMap, type SheetMap} from './sheet-map.js';
import type {Writing} from './writing.js';
import {outlineOf} from './pdf-outline.js';
import {headingWords, together, withDashes, type SizeSheet} from './several-sizes.js';
import {projectedMarks} from './projected.js';
import {marksOnPages} from './words-on-page.js';

export interface CuttingPdfOptions {
  readonly paper: Paper;
  /** Draws the print in place, tinted to save ink, or lines only. Default full. */
  readonly ink?: PrintInk;
  /** Adds pages that help to place the pieces on printed fabric; none for a projector. */
  readonly guide?: GuideOptions;
  /** Watermark on every page, such as `notAsSold`. */
  readonly mark?: string;
  /** Date on every page. Without it, the same sheet gives the same bytes. */
  readonly date?: Date;
  readonly pixels?: CellPixels;
  /** Letters that the embedded font does not have. */
  readonly letters?: OtherLetters;
  /**
   * Sheets of other sizes on the places of the sheet, each on its own layer; all of them have sizes.
   * There is no placing guide then.
   */
  readonly otherSizes?: readonly SizeSheet[];
}

export interface CuttingPdf {
  readonly bytes: Uint8Array<ArrayBuffer>;
  readonly layout: PageLayout;
  readonly map: SheetMap;
  /** One sentence each. */
  readonly notes: readonly string[];
}

/** The pages of a sheet. This is fast enough for a preview before the file is written. */
export const pagesOf = (sheet: CutSheet, paper: Paper): PageLayout =>
  dividedAmong(sheet, paper, (hasMap) => roomOf(sheet, paper, hasMap));

/** Ratios of width to height tried for a sheet. */
const aspects = [1.4, 0.6, 2.8];

/** The sheet with the fewest pages, and with the least paper among equals. */
export function sheetFor(paper: Paper, lay: (aspect: number) => CutSheet): CutSheet {
  const tried = (paper.isProjector ? aspects.slice(0, 1) : aspects).map((aspect) => {
    const sheet = lay(aspect);
    const {pages, widthCm, heightCm} = pagesOf(sheet, paper);
    return {sheet, cost: pages.length * 1e6 + widthCm * heightCm};
  });
  const least = Math.min(...tried.map(({cost}) => cost));
  return (tried.find(({cost}) => cost === least) ?? {sheet: lay(aspects[0] ?? 1)}).sheet;
}

/** Returns whether two prints are equal in size and image. */
const isSamePrint = (a: PrintWithTile, b: PrintWithTile | undefined): boolean =>
  JSON.stringify([a.w1, a.w2, a.tile]) === JSON.stringify([b?.w1, b?.w2, b?.tile]);

type LayerName = keyof SheetTexts['layers'];

/** The pieces of a size. */
interface DrawnSize {
  /** Assigns content to the layer of the size, if there are several. */
  readonly sized: (...parts: readonly string[]) => string;
  readonly marks: readonly (readonly CutMark[])[];
  readonly fabric: (window: Box) => string;
}

/** Content common to all pages of a file. */
interface Drawing extends Writing {
  readonly sheet: CutSheet;
  readonly layout: PageLayout;
  readonly layers: Readonly<Record<LayerName, string>>;
  readonly sizes: readonly DrawnSize[];
  readonly foot: string;
  readonly mark: string | undefined;
  /** Number of all pages. */
  readonly count: number;
}

const gridSide = 5;
const gridLine = 0.03;

/** Grid for calibrating a projector. */
function drawnGrid({low, high}: Box): string {
  const steps = (axis: 0 | 1): number[] => {
    const first = Math.ceil(low[axis] / gridSide);
    const count = Math.floor(high[axis] / gridSide) - first + 1;
    return Array.from({length: count}, (_, k) => (first + k) * gridSide);
  };
  const upright = steps(0).map((x) =>
    line([
      [x, low[1]],
      [x, high[1]],
    ]),
  );
  const level = steps(1).map((y) =>
    line([
      [low[0], y],
      [high[0], y],
    ]),
  );
  return scoped(`${nums(gridLine)} w`, strokedWith([0.6, 0.6, 0.6]), ...upright, ...level, 'S');
}

/** Text across the page's diagonal, as large as fits. */
function drawnAcross(words: string, {low, high}: Box, resources: PdfResources): string {
  const [width, height] = [high[0] - low[0], high[1] - low[1]];
  const size = (0.8 * Math.hypot(width, height)) / widthOf(words, 'bold');
  return scoped(
    `/${resources.opacity(0.55)} gs`,
    filledWith([0.76, 0.15, 0.11]),
    textAt(resources, middle(low, high), words, {
      ...{size, weight: 'bold', align: 'middle', angle: Math.atan2(height, width)},
    }),
  );
}

function pageContent(page: SheetPage, number: number, drawing: Drawing): string {
  const {sheet, layout, resources, layers, sizes, foot, mark, count} = drawing;
  const {window, low, name} = page;
  const {isProjector} = layout.paper;
  const toPoints = {
    ...{xx: pointsPerCm, xy: 0, yx: 0, yy: pointsPerCm},
    shift: [-low[0] * pointsPerCm, -low[1] * pointsPerCm] as const,
  };
  const pieces = scoped(
    `${line(cornersOf(window), true)}\nW n`,
    ...sizes.map(({sized, fabric}) => sized(onLayer(layers.print, fabric(window)))),
    isProjector ? '' : onLayer(layers.frame, drawFrame(page, layout, resources)),
    isProjector ? onLayer(layers.grid, drawnGrid(window)) : '',
    ...sizes.map(({sized, marks}) =>
      sized(...marks.map((some) => drawMarks(some, window, layers, resources))),
    ),
  );
  const about = [
    isProjector ? '' : drawFoot(page, foot, {number, count}, drawing),
    number === 1 ? drawFirstPage(sheet, layout, resources) : '',
  ];
  return scoped(
    through(toPoints),
    name === undefined ? '' : pieces,
    onLayer(layers[isProjector ? 'words' : 'frame'], ...about),
    mark === undefined ? '' : drawnAcross(mark, window, resources),
  );
}

/** A page of the placing guide, with the footer of all pages. */
function guideContent(content: string, number: number, drawing: Drawing): string {
  const {layout, layers, foot, mark, resources, count} = drawing;
  const {widthCm, heightCm} = layout;
  const page = boxAt([0, 0], widthCm, heightCm);
  const window = grown(page, -usualMargin);
  return scoped(
    through({xx: pointsPerCm, xy: 0, yx: 0, yy: pointsPerCm, shift: [0, 0]}),
    onLayer(
      layers.frame,
      content,
      drawFoot({low: page.low, window}, foot, {number, count}, drawing),
    ),
    mark === undefined ? '' : drawnAcross(mark, window, resources),
  );
}

/**
 * Writes the file, and a map of its content. `print.tile` is the image of the print's cell, as SVG
 * text or `data:` URL.
 * @throws {FileError} if the image cannot be drawn
 */
export async function cuttingPdf(
  drawnSheet: CutSheet,
  print: PrintWithTile,
  {paper, ink = 'full', guide, mark, date, pixels, letters, otherSizes = []}: CuttingPdfOptions,
): Promise<CuttingPdf> {
  const notes: string[] = [];
  const texts = sheetTextsIn(drawnSheet.locale);
  const all: readonly SizeSheet[] = [{sheet: drawnSheet, print}, ...otherSizes];
  const sheets = all.map((one) => one.sheet);
  const sheet = together(sheets, texts) ?? drawnSheet;
  const layout = pagesOf(sheet, paper);
  const document = new PdfDocument();
  const resources = new PdfResources(document);
  const {isProjector = false} = paper;
  const hasGuide = guide !== undefined && !isProjector && otherSizes.length === 0;
  const unused = new Set<LayerName>([
    ...(isProjector ? (['sew', 'frame'] as const) : (['grid'] as const)),
    ...(ink === 'outline' ? (['print'] as const) : []),
  ]);
  const sizeLayers =
    all.length < 2
      ? []
      : sheets.map(({size = ''}, k) => resources.layer(texts.size(size), k === 0));
  const layers = Object.fromEntries(
    Object.entries(texts.layers).map(([key, name]) => [
      key,
      unused.has(key as LayerName) ? '' : resources.layer(name),
    ]),
  ) as Record<LayerName, string>;
  const sizes: DrawnSize[] = [];
  let cell: Cell | undefined;
  for (const [k, one] of all.entries()) {
    const isNew = cell === undefined || !isSamePrint(one.print, all[k - 1]?.print);
    if (isNew && (ink !== 'outline' || hasGuide)) {
      cell = await fabricCell(resources, one.print, pixels, (sentence) => notes.push(sentence));
    }
    const layer = sizeLayers[k] ?? '';
    const drawn = ink === 'outline' ? undefined : cell;
    sizes.push({
      sized: (...parts) => (layer === '' ? parts.join('\n') : onLayer(layer, ...parts)),
      marks: one.sheet.pieces.map((piece) =>
        withDashes(isProjector ? projectedMarks(piece) : marksOnPages(piece, layout.pages), k),
      ),
      fabric: (window) =>
        drawn
          ? one.sheet.pieces
              .map((piece) =>
                fabricUnder(resources, drawn, piece, {window, isPale: ink === 'pale'}),
              )
              .join('\n')
          : '',
    });
  }
  const day = date?.toISOString().slice(0, 10);
  const words = [...headingWords(sheets, texts), printTitle(print, texts), ...(day ? [day] : [])];
  const drawing: Drawing = {
    ...{sheet, layout, resources, texts, layers, sizes, mark},
    foot: words.filter((word) => word !== '').join('  ·  '),
    count: layout.pages.length + (hasGuide ? guideCount(layout, sheet.pieces) : 0),
  };
  const pages = layout.pages.map((page, k) => ({
    ...{widthCm: layout.widthCm, heightCm: layout.heightCm, label: page.name ?? texts.overview},
    content: () => pageContent(page, k + 1, drawing),
  }));
  const guided =
    hasGuide && cell
      ? guidePages(sheet.pieces, layout, {drawing: {resources, texts, cell}, print, options: guide})
      : [];
  const guides = guided.map((content, k) => ({
    ...{widthCm: layout.widthCm, heightCm: layout.heightCm, label: texts.guide},
    content: () => guideContent(content(), layout.pages.length + k + 1, drawing),
  }));
  const {bytes, missing} = await pdfFile(document, resources, [...pages, ...guides], {
    ...{title: sheet.heading, mode: isProjector || all.length > 1 ? 'UseOC' : 'UseNone'},
    ...(date && {date}),
    ...(letters && {letters}),
    ...(sheet.locale !== undefined && {locale: sheet.locale}),
    outline: (refs) => outlineOf(document, drawnSheet, layout.pages, refs),
  });
  notes.push(...missingNotes(missing));
  return {bytes, layout, map: sheetMap(sheet, layout), notes};
}
