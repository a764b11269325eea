/** Writes a cutting sheet as PDF at true scale, on pages of paper or for a projector. */
import type {CutMark, CutSheet} from '../cutting/cut-sheet.js';
import type {PrintInk} from '../cutting/print-ink.js';
import {middle, type Point} from '../model/geometry/vectors.js';
import {boxOf, isInside, type Box} from '../model/geometry/polyline.js';
import type {PrintWithTile} from '../picture/cloth.js';
import {boxAt, cornersOf, grown, overlap} from './boxes.js';
import {clothUnder} from './cell.js';
import {clothCell, type CellPixels} from './cloth-cell.js';
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
import {PdfDocument, refTo, textString, type Ref} from '../files/pdf/document.js';
import {missingNotes, pdfFile} from '../files/pdf/file.js';
import {PdfResources} from '../files/pdf/resources.js';
import type {OtherLetters} from '../files/pdf/fonts/other-letters.js';
import {textAt, widthOf} from '../files/pdf/text.js';
import {printTitle} from '../cutting/words.js';
import {sheetTextsIn, type SheetTexts} from '../texts/sheet-texts.js';
import {sheetMap, type SheetMap} from './sheet-map.js';
import type {Writing} from './writing.js';
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

type LayerName = keyof SheetTexts['layers'];

/** Content common to all pages of a file. */
interface Drawing extends Writing {
  readonly sheet: CutSheet;
  readonly layout: PageLayout;
  readonly layers: Readonly<Record<LayerName, string>>;
  readonly marks: readonly (readonly CutMark[])[];
  readonly cloth: (window: Box) => string;
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
  const {sheet, layout, resources, layers, marks, cloth, foot, mark, count} = drawing;
  const {window, low, name} = page;
  const {isProjector} = layout.paper;
  const toPoints = {
    ...{xx: pointsPerCm, xy: 0, yx: 0, yy: pointsPerCm},
    shift: [-low[0] * pointsPerCm, -low[1] * pointsPerCm] as const,
  };
  const pieces = scoped(
    `${line(cornersOf(window), true)}\nW n`,
    onLayer(layers.print, cloth(window)),
    isProjector ? '' : onLayer(layers.frame, drawFrame(page, layout, resources)),
    isProjector ? onLayer(layers.grid, drawnGrid(window)) : '',
    ...marks.map((some) => drawMarks(some, window, layers, resources)),
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
 * The document outline: an entry per piece, for the page with its middle, otherwise with a part of
 * it.
 */
function outlineOf(
  document: PdfDocument,
  {pieces}: CutSheet,
  pages: readonly SheetPage[],
  refs: readonly Ref[],
): Ref {
  const root = document.reserve();
  const items = pieces.map(() => document.reserve());
  pieces.forEach(({label, cut}, k) => {
    const around = boxOf(cut[0] ?? []);
    const centre: Point = middle(around.low, around.high);
    const shown = pages.findIndex(({frame}) => isInside(cornersOf(frame), centre));
    const touched = pages.findIndex(({frame}) => overlap(frame, around));
    const page = refs[Math.max(0, shown < 0 ? touched : shown)] ?? 0;
    const [before, next] = [items[k - 1], items[k + 1]];
    document.set(
      items[k] ?? 0,
      [
        `<</Title ${textString(label)}/Parent ${refTo(root)}/Dest[${refTo(page)}/Fit]`,
        before === undefined ? '' : `/Prev ${refTo(before)}`,
        next === undefined ? '' : `/Next ${refTo(next)}`,
        '>>',
      ].join(''),
    );
  });
  const [first = 0, last = 0] = [items[0], items.at(-1)];
  document.set(
    root,
    `<</Type/Outlines/First ${refTo(first)}/Last ${refTo(last)}/Count ${items.length}>>`,
  );
  return root;
}

/** Title and size, which are on every page. */
const headingWords = ({heading, title, size}: CutSheet, texts: SheetTexts): readonly string[] =>
  size === undefined ? [heading] : [title ?? '', texts.size(size)];

/**
 * Writes the file, and a map of its content. `print.tile` is the image of the print's cell, as SVG
 * text or `data:` URL.
 * @throws {FileError} if the image cannot be drawn
 */
export async function cuttingPdf(
  sheet: CutSheet,
  print: PrintWithTile,
  {paper, ink = 'full', guide, mark, date, pixels, letters}: CuttingPdfOptions,
): Promise<CuttingPdf> {
  const notes: string[] = [];
  const texts = sheetTextsIn(sheet.locale);
  const layout = pagesOf(sheet, paper);
  const document = new PdfDocument();
  const resources = new PdfResources(document);
  const {isProjector = false} = paper;
  const hasGuide = guide !== undefined && !isProjector;
  const unused = new Set<LayerName>([
    ...(isProjector ? (['sew', 'frame'] as const) : (['grid'] as const)),
    ...(ink === 'outline' ? (['print'] as const) : []),
  ]);
  const layers = Object.fromEntries(
    Object.entries(texts.layers).map(([key, name]) => [
      key,
      unused.has(key as LayerName) ? '' : resources.layer(name),
    ]),
  ) as Record<LayerName, string>;
  const cell =
    ink === 'outline' && !hasGuide
      ? undefined
      : await clothCell(resources, print, pixels, (sentence) => notes.push(sentence));
  const day = date?.toISOString().slice(0, 10);
  const words = [...headingWords(sheet, texts), printTitle(print, texts), ...(day ? [day] : [])];
  const drawing: Drawing = {
    ...{sheet, layout, resources, texts, layers, mark},
    marks: sheet.pieces.map((piece) =>
      isProjector ? projectedMarks(piece) : marksOnPages(piece, layout.pages),
    ),
    cloth: (window) =>
      cell && ink !== 'outline'
        ? sheet.pieces
            .map((piece) => clothUnder(resources, cell, piece, {window, isPale: ink === 'pale'}))
            .join('\n')
        : '',
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
    ...{title: sheet.heading, mode: isProjector ? 'UseOC' : 'UseNone'},
    ...(date && {date}),
    ...(letters && {letters}),
    ...(sheet.locale !== undefined && {locale: sheet.locale}),
    outline: (refs) => outlineOf(document, sheet, layout.pages, refs),
  });
  notes.push(...missingNotes(missing));
  return {bytes, layout, map: sheetMap(sheet, layout), notes};
}
