/** Opens a PDF with pdf.js and reads its pages one after the other. */
import {FileError} from '../../../model/base/versioned-file.js';
import {after, planeMap, scaling, shifting, turning} from '../../../model/geometry/plane-map.js';
import {pdfJs} from './load.js';
import type {PageInk} from './ink.js';
import {OperatorPort} from './operator-port.js';
import {inkReader, type PageFrame} from './page-ink.js';
import {ReadingBudget} from './reading-budget.js';

/** A layer of the file. */
export interface PdfLayer {
  readonly name: string;
  /** True if viewers show it at first. */
  readonly isShown: boolean;
}

export interface PdfPages {
  readonly pages: readonly PageInk[];
  readonly layers: readonly PdfLayer[];
  /** Number of pages of the file. */
  readonly count: number;
  /** True if the file contains pictures, which are not read. */
  readonly hasPictures: boolean;
  readonly title?: string;
  readonly program?: string;
  readonly notes: readonly string[];
}

/** Greatest number of pages that are read. */
const mostPages = 200;

const millimetresPerPoint = 25.4 / 72;

/** Greatest side of a page; viewers show no larger ones. [mm] */
const longestSide = 6000;

interface PageChoice {
  /** Page numbers to read, from 1; all without it. */
  readonly pages?: readonly number[];
  /** Called after each page. */
  readonly onPage?: (read: number, count: number) => Promise<void>;
}

type Library = Awaited<ReturnType<typeof pdfJs>>['library'];
type Document = Awaited<ReturnType<Library['getDocument']>['promise']>;
type Page = Awaited<ReturnType<Document['getPage']>>;

/**
 * Reads the lines and words of all pages.
 * @throws {FileError} if the file is locked, damaged or too large
 */
export async function openPdf(
  bytes: Uint8Array,
  file: string,
  {pages: chosen, onPage}: PageChoice,
): Promise<PdfPages> {
  const {library, connect} = await pdfJs();
  const port = new OperatorPort();
  const worker = connect(port);
  const task = library.getDocument({
    worker,
    // pdf.js reads whole buffers, and none of Node
    data: wholeBuffer(bytes),
    ...{isEvalSupported: false, enableXfa: false, useWasm: false, useWorkerFetch: false},
    ...{disableFontFace: true, useSystemFonts: false, fontExtraProperties: false},
    ...{disableAutoFetch: true, disableStream: true, isOffscreenCanvasSupported: false},
    ...{isImageDecoderSupported: false, maxImageSize: 1, verbosity: 0},
  });
  try {
    const document = await opened(task.promise, file);
    const count = document.numPages;
    const numbers = pagesToRead(chosen, count, file);
    const {layers, names} = await layersOf(document);
    const budget = new ReadingBudget();
    const pages: PageInk[] = [];
    const notes: string[] = [];
    for (const [k, number] of numbers.entries()) {
      try {
        const page = await document.getPage(number);
        pages.push(await inkOf(page, number, {library, port, names, budget}));
        page.cleanup();
      } catch {
        notes.push(`Page ${number} is damaged, and left out.`);
      }
      if (budget.exceeded !== undefined) {
        throw new FileError(
          file,
          `has more than ${budget.exceeded} up to page ${number}, as pictures and books have; choose its pattern pages, or export the outlines alone.`,
          {reason: 'complex'},
        );
      }
      await onPage?.(k + 1, numbers.length);
    }
    if (pages.length === 0)
      throw new FileError(file, 'has no page that can be read; export it again.', {
        reason: 'damaged',
      });
    const unread = pages.find(({hasMoreMarks}) => hasMoreMarks)?.number;
    if (unread !== undefined) {
      notes.push(
        `Some filled marks from page ${unread} on are left out, as the file has too many; choose its pattern pages.`,
      );
    }
    if (chosen === undefined && count > numbers.length) {
      notes.push(
        `The file has ${count} pages, of which the first ${numbers.length} are read; choose others by their numbers.`,
      );
    }
    return {
      ...{pages, layers, count, notes, hasPictures: containsPictures(bytes)},
      ...(await about(document)),
    };
  } finally {
    await task.destroy();
    worker.destroy();
  }
}

const wholeBuffer = (bytes: Uint8Array): Uint8Array =>
  bytes.byteLength === bytes.buffer.byteLength
    ? new Uint8Array(bytes.buffer)
    : new Uint8Array(bytes);

function pagesToRead(
  chosen: readonly number[] | undefined,
  count: number,
  file: string,
): readonly number[] {
  if (!chosen) return Array.from({length: Math.min(count, mostPages)}, (_, k) => k + 1);
  const inFile = chosen.filter((number) => number <= count);
  if (inFile.length > 0) return inFile.slice(0, mostPages);
  throw new FileError(
    file,
    `has ${count} ${count === 1 ? 'page' : 'pages'} and no page ${chosen[0] ?? 0}; choose other pages.`,
  );
}

/** @throws {FileError} with the reason in one sentence */
async function opened(document: Promise<Document>, file: string): Promise<Document> {
  try {
    return await document;
  } catch (cause) {
    const {name} = cause as Error;
    const isLocked = name === 'PasswordException';
    throw new FileError(
      file,
      isLocked
        ? 'is locked by a password; open it in a PDF viewer, and save it without one.'
        : 'is a damaged PDF; download or export it again.',
      {cause, reason: isLocked ? 'locked' : 'damaged'},
    );
  }
}

/** The layers, and their names by the identifiers of pdf.js. */
async function layersOf(
  document: Document,
): Promise<{readonly layers: readonly PdfLayer[]; readonly names: ReadonlyMap<string, string>}> {
  const names = new Map<string, string>();
  const layers = new Map<string, PdfLayer>();
  try {
    const config = await document.getOptionalContentConfig();
    for (const [id, group] of config as Iterable<[string, {name?: unknown; visible?: unknown}]>) {
      const {name: stated, visible} = group;
      const name = typeof stated === 'string' && stated.trim() !== '' ? stated.trim() : id;
      names.set(id, name);
      layers.set(name, {name, isShown: visible !== false});
    }
  } catch {
    // a file with damaged layers is read without them
  }
  return {layers: [...layers.values()], names};
}

async function inkOf(
  page: Page,
  number: number,
  {
    library,
    port,
    names,
    budget,
  }: {
    readonly library: Library;
    readonly port: OperatorPort;
    readonly names: ReadonlyMap<string, string>;
    readonly budget: ReadingBudget;
  },
): Promise<PageInk> {
  const {read, result} = inkReader(library.OPS, frameOf(page, number), names, budget);
  const exceeded = new Promise<never>((_, reject) => {
    // pdf.js would ignore the error of a form, and read on
    port.onOperators = (list) => {
      try {
        read(list);
      } catch (error) {
        port.onOperators = undefined;
        reject(error instanceof Error ? error : new Error(String(error)));
      }
    };
  });
  const {DISABLE} = library.AnnotationMode;
  await Promise.race([page.getOperatorList({intent: 'print', annotationMode: DISABLE}), exceeded]);
  return result();
}

/** Size of the parts in which a file is searched, and their overlap. [bytes] */
const searched = {size: 2 ** 20, overlap: 32};

/**
 * Returns whether the file contains pictures. Their entries are never compressed, and pdf.js does
 * not report pictures that it does not decode.
 */
function containsPictures(bytes: Uint8Array): boolean {
  const decoder = new TextDecoder('latin1');
  for (let from = 0; from < bytes.length; from += searched.size) {
    const part = bytes.subarray(from, from + searched.size + searched.overlap);
    if (/\/Subtype\s*\/Image\b/.test(decoder.decode(part))) return true;
  }
  return false;
}

/** The page as it is shown: turned, and from its lower left corner. */
function frameOf(page: Page, number: number): PageFrame {
  const [x0 = 0, y0 = 0, x1 = 0, y1 = 0] = page.view;
  const scale = millimetresPerPoint * (page.userUnit || 1);
  const [across, up] = [(x1 - x0) * scale, (y1 - y0) * scale];
  const turn = ((page.rotate % 360) + 360) % 360;
  const unturned = after(scaling(scale), shifting(-x0, -y0));
  // the corner that becomes the lower left one
  const corner = {90: [0, across], 180: [across, up], 270: [up, 0]}[turn] ?? [0, 0];
  const map = after(planeMap(1, 0, 0, 1, corner[0], corner[1]), after(turning(-turn), unturned));
  const [width, height] = turn % 180 === 0 ? [across, up] : [up, across];
  if (!(width > 0 && height > 0 && Math.max(width, height) <= longestSide)) {
    throw new RangeError('no size');
  }
  return {number, width, height, map};
}

async function about(document: Document): Promise<{title?: string; program?: string}> {
  try {
    const {info} = await document.getMetadata();
    const {Title, Creator} = info as {readonly Title?: unknown; readonly Creator?: unknown};
    const said = (value: unknown): string | undefined =>
      typeof value === 'string' && value.trim() !== '' ? value.trim() : undefined;
    const [title, program] = [said(Title), said(Creator)];
    return {...(title !== undefined && {title}), ...(program !== undefined && {program})};
  } catch {
    return {};
  }
}
