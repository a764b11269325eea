/** Reads files of other programs as drawings. */
import type {Drawing, DrawingOptions} from '../model/garment/imported-drawing.js';
import {FileError} from '../model/base/versioned-file.js';
import {readDxf} from './dxf/read-dxf.js';
import {readObj} from './obj/read-obj.js';
import {decoded} from './base/decoded.js';
import {recognised, type DrawingKind} from './recognise.js';
import type {PdfPages} from './pdf/read/open-pdf.js';
import {readSvg} from './svg/read-svg.js';

/** Greatest size of a pattern file. [bytes] */
export const drawingLimit = 64_000_000;

type Read = (bytes: Uint8Array, name: string, options: DrawingOptions) => Drawing;

const readers: Readonly<Record<Exclude<DrawingKind, 'pdf'>, Read>> = {
  dxf: readDxf,
  svg: (bytes, name, options) => readSvg(decoded(bytes), name, options),
  obj: (bytes, name, {units}) => readObj(bytes, name, units),
};

/** Returns whether a byte is white space or zero. */
const isBlank = (byte: number): boolean => byte === 0 || byte === 32 || (byte > 8 && byte < 14);

/**
 * Reads a drawing in any format but PDF.
 * @param name file name for messages
 * @throws {FileError} with the file, the error and a remedy
 */
export function readDrawing(
  bytes: Uint8Array,
  name: string,
  options: DrawingOptions = {},
): Drawing {
  const kind = kindOf(bytes, name, options);
  if (kind === 'pdf') throw new TypeError('readAnyDrawing reads PDF');
  const [flag] = Object.keys(options).filter((key) => ofPdf.has(key));
  if (flag !== undefined) {
    throw new FileError(name, `is no PDF, so that it has no ${ofPdf.get(flag) ?? ''} to choose.`);
  }
  return readers[kind](bytes, name, options);
}

/** Options that only PDF has, in words. */
const ofPdf: ReadonlyMap<string, string> = new Map<keyof DrawingOptions, string>([
  ['pages', 'pages'],
  ['grid', 'grid of pages'],
  ['places', 'places of pages'],
  ['trimCm', 'trim'],
  ['overlapCm', 'overlap'],
  ['allowanceCm', 'allowance'],
]);

/** A drawing, and the read pages of a PDF. */
interface Opened {
  readonly drawing: Drawing;
  readonly opened?: OpenedPages;
}

export type OpenedPages = PdfPages;

/** Receives the number of read pages of a PDF, and their count. */
type OnPage = (read: number, count: number) => Promise<void>;

/**
 * Reads a drawing in any format. The reader of PDF is loaded only for PDF.
 * @param name file name for messages
 * @throws {FileError} with the file, the error and a remedy
 */
export async function readAnyDrawing(
  bytes: Uint8Array,
  name: string,
  options: DrawingOptions = {},
): Promise<Drawing> {
  if (kindOf(bytes, name, options) !== 'pdf') return readDrawing(bytes, name, options);
  const {openedPdf, drawingOfPdf} = await import('./pdf/read/read-pdf.js');
  return drawingOfPdf(await openedPdf(bytes, name, options.pages), name, options);
}

/**
 * Reads a drawing for a user who may correct how the pages of a PDF are put together, so that a
 * PDF may show no pieces.
 * @throws the errors of `readAnyDrawing`
 */
export async function openedDrawing(
  bytes: Uint8Array,
  name: string,
  options: DrawingOptions,
  onPage: OnPage,
): Promise<Opened> {
  if (kindOf(bytes, name, options) !== 'pdf') return {drawing: readDrawing(bytes, name, options)};
  const {openedPdf} = await import('./pdf/read/read-pdf.js');
  const opened = await openedPdf(bytes, name, options.pages, onPage);
  return {opened, drawing: await drawingOfPages(opened, name, options)};
}

/** Puts the read pages of a PDF together. @throws the errors of `readAnyDrawing` */
export async function drawingOfPages(
  opened: OpenedPages,
  name: string,
  options: DrawingOptions,
): Promise<Drawing> {
  const {drawingOfPdf} = await import('./pdf/read/read-pdf.js');
  return drawingOfPdf(opened, name, options, true);
}

/** @throws {FileError} if the file is none that can be read */
function kindOf(bytes: Uint8Array, name: string, options: DrawingOptions): DrawingKind {
  if (bytes.length > drawingLimit) {
    throw new FileError(
      name,
      `is larger than ${drawingLimit / 1e6} MB, which no pattern is; export the pieces of one garment alone.`,
      {reason: 'complex'},
    );
  }
  if (bytes.every(isBlank))
    throw new FileError(name, 'is empty; export it again.', {reason: 'empty'});
  const kind = recognised(bytes);
  if (kind === undefined) {
    throw new FileError(
      name,
      'is no pattern that can be read, or damaged; export it again, as PDF, DXF (AAMA or ASTM), SVG or OBJ.',
      {reason: 'unreadable'},
    );
  }
  if (typeof kind !== 'string') throw new FileError(name, kind.refusal, {reason: kind.reason});
  if (options.pixelsPerInch !== undefined && kind !== 'svg') {
    throw new FileError(name, 'is no SVG and has no pixels; give its unit as mm, cm or in.');
  }
  if (options.scale !== undefined && kind === 'obj') {
    throw new FileError(
      name,
      'is OBJ, whose pieces have the size of its garment; leave its scale out.',
    );
  }
  return kind;
}
