/** Reads sewing patterns from PDF as drawings of pieces. */
import type {
  AssembledPages,
  Drawing,
  DrawingOptions,
} from '../../../model/garment/imported-drawing.js';
import type {Point} from '../../../model/geometry/vectors.js';
import {FileError} from '../../../model/base/versioned-file.js';
import {genericPieces} from '../../svg/generic.js';
import {assembled, type Sheet} from './assemble.js';
import {withAllowance} from './allowance.js';
import {statedAllowance} from './allowance-words.js';
import type {PageInk} from './ink.js';
import {withOpenCutLines} from './open-cut-lines.js';
import {withoutHatching} from './hatching.js';
import {openPdf, type PdfPages} from './open-pdf.js';
import {assemblyNotes, whyNoPiece} from './notes.js';
import {withoutGrid} from './projector-grid.js';
import {drawingOf} from './sheet-drawing.js';
import {chosenSize} from './sizes.js';
import {ignoringStrayRejections} from './stray-rejections.js';
import {isTrueToScale, testSquaresIn} from './squares.js';

/**
 * Reads the pages of a file.
 * @throws {FileError} if they cannot be read
 */
export const openedPdf = (
  bytes: Uint8Array,
  file: string,
  pages: readonly number[] | undefined,
  onPage?: (read: number, count: number) => Promise<void>,
): Promise<PdfPages> =>
  ignoringStrayRejections(() =>
    openPdf(bytes, file, {...(pages && {pages}), ...(onPage && {onPage})}),
  );

/** The layer of our own files in which pieces have their names. */
const wordsLayer = 'Words';

/**
 * The pieces of a file.
 * @param isOffered true if the user may correct how pages are put together, so that a sheet without
 *   pieces is no error
 * @throws {FileError} without readable pieces
 */
export function drawingOfPdf(
  pdf: PdfPages,
  file: string,
  options: DrawingOptions = {},
  isOffered = false,
): Drawing {
  const {layers, title, program} = pdf;
  if (options.units) {
    throw new FileError(file, 'is PDF, whose pages have a size of their own; leave its unit out.');
  }
  const {places} = options;
  const chosen = places?.map(({number}) => number) ?? options.pages;
  const whole = assembled(chosenPages(pdf.pages, chosen), {
    isExact: chosen !== undefined,
    ...(places && {
      places: new Map(places.map(({number, cell: [column, row]}) => [number, {row, column}])),
    }),
    ...(options.without && {without: options.without}),
    ...(options.grid && {grid: options.grid}),
    ...(options.trimCm !== undefined && {trim: 10 * options.trimCm}),
    ...(options.overlapCm !== undefined && {overlap: 10 * options.overlapCm}),
  });
  const {squares, ratio} = testSquaresIn(whole.lines, whole.texts);
  const scale = options.scale ?? ratio ?? 1;
  const isScaled = !isTrueToScale(scale);
  const isOwn = layers.some(({name}) => name === wordsLayer);
  const bare = withoutHatching(whole.lines.filter((line) => !squares.has(line)));
  const {lines, notes: gridNotes} = withoutGrid(bare.lines);
  const sheet = {
    lines: isScaled
      ? lines.map((one) => ({...one, points: scaledPoints(one.points, scale)}))
      : lines,
    texts: whole.texts
      .filter(({layer}) => !isOwn || layer === wordsLayer)
      .map((text) =>
        isScaled
          ? {
              ...text,
              from: scaled(text.from, scale),
              to: scaled(text.to, scale),
              size: scale * text.size,
            }
          : text,
      ),
  };
  const sized = chosenSize(sheet, layers, options.size, file);
  const drawn = drawingOf(sized, program);
  const found = genericPieces(drawn);
  const why = found.pieces.length > 0 ? undefined : whyNoPiece(pdf, whole, found.notes);
  if (why !== undefined && !(isOffered && whole.lines.length > 0)) {
    throw new FileError(file, why.refusal, why);
  }
  const stated = statedAllowance(pdf.pages.flatMap(({texts}) => texts.map(({text}) => text)));
  const pieces = withOpenCutLines(found.pieces, drawn);
  const allowed = withAllowance(pieces, options.allowanceCm, stated);
  return {
    kind: 'pdf',
    ...(program !== undefined && {program}),
    ...(title !== undefined && {title}),
    ...{sizes: sized.sizes, ...(sized.size !== undefined && {size: sized.size})},
    unit: {
      ...{unit: 'mm', isSure: true, others: []},
      because: ratio === undefined || options.scale !== undefined ? 'stated' : 'measured',
    },
    pieces: allowed.pieces,
    seams: [],
    pages: placed(whole, isScaled ? scale : 1, pdf),
    notes: [
      ...(why === undefined ? [] : [`${file} ${why.refusal}`]),
      ...assemblyNotes(whole, pdf),
      ...(isScaled && ratio !== undefined && options.scale === undefined ? [scaleNote(ratio)] : []),
      ...[
        ...bare.notes,
        ...gridNotes,
        ...sized.notes,
        ...allowed.notes,
        ...found.notes,
        ...pdf.notes,
      ],
    ],
  };
}

const scaled = ([x, y]: Point, by: number): Point => [by * x, by * y];
const scaledPoints = (points: readonly Point[], by: number): Point[] =>
  points.map((p) => scaled(p, by));

function chosenPages(
  pages: readonly PageInk[],
  chosen: readonly number[] | undefined,
): readonly PageInk[] {
  return chosen
    ? chosen.flatMap((number) => pages.find((one) => one.number === number) ?? [])
    : pages;
}

const scaleNote = (ratio: number): string =>
  `By its test square it is drawn at ${(100 / ratio).toFixed(1)} % of its size, and taken ${ratio.toFixed(4)} times as large.`;

/** The places of the pages, for the preview. [mm] */
function placed(sheet: Sheet, scale: number, {count}: PdfPages): AssembledPages {
  const {pages, others, columns, rows, overlap, trim, openJoints} = sheet;
  return {
    ...{count, others, columns, rows, openJoints},
    ...(trim !== undefined && {trimCm: trim / 10}),
    ...(overlap && {overlapCm: [overlap[0] / 10, overlap[1] / 10] as const}),
    placed: pages.map(({number, cell, box}) => ({
      number,
      ...(cell && {cell: [cell.column, cell.row] as const}),
      low: scaled(box.low, scale),
      high: scaled(box.high, scale),
    })),
  };
}
