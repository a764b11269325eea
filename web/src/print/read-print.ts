/** Reads a file as a print: a print file, or the image of one cell. */
import {noPicture, type DesignPrint} from '../model/design/design.js';
import {distance, norm} from '../model/geometry/vectors.js';
import type {Print} from '../model/print/repeating-print.js';
import {readPrintFile} from '../model/print/read-print-file.js';
import {fieldOf} from '../model/base/read.js';
import {latticeVectors, leastRepeat, mostRepeat, repeatOf} from '../model/print/repeat.js';
import type {OwnPicture} from '../model/design/tile-repeat.js';
import {FileError} from '../model/base/versioned-file.js';
import {en, type Texts} from '../texts/en.js';
import type {ReadsPictures} from './own-groups.js';
import {printOfPicture} from './own-print.js';
import {looksLikePicture, readPicture} from './read-picture.js';
import {fileKind} from '../image/file-kind.js';
import {dpiOf, lengthOnPaper, resolutionOf, rootAttribute} from '../image/printed-size.js';
import {blobOf} from '../image/data-url.js';
import {loadPicture} from './picture-pixels.js';

/** Greatest length of a print file. [bytes] */
const mostBytes = 12 * 2 ** 20;
/** Width of an image until its file or the user sets another one. [cm] */
export const firstWidth = 10;

type Words = Texts['print']['files'];

/**
 * Reads an image as opened: straight, in the size from its file.
 * @throws {Error} with one sentence as message
 */
export async function readOwnPicture(file: File, words: Words): Promise<OwnPicture> {
  const {image, width, height} = await readPicture(file, words);
  const said = await sizeInFile(image);
  const across = said?.width ?? firstWidth;
  return {
    ...{title: file.name.replace(/\.[^.]*$/, ''), image, repeat: 'straight', turnDeg: 0},
    size: {width: across, height: (across * height) / width, angleDeg: 90},
  };
}

/**
 * Returns a print as a design contains it. An image has the first of its groups. A print file names
 * its image, which cannot be read from here; the fabric is bare until the user opens the image,
 * too.
 * @throws {Error} with one sentence about the problem
 */
export async function readPrint(
  solver: ReadsPictures,
  file: File,
  words: Words = en.print.files,
): Promise<DesignPrint> {
  if (await looksLikePicture(file))
    return printOfPicture(solver, await readOwnPicture(file, words));
  if (file.size > mostBytes) throw new Error(words.tooLarge(file.name));
  const text = await file.text();
  return onItsFabric(printFrom(text, file.name, words), text, file.name);
}

/**
 * The print after the wash of the fabric that its file states.
 * @throws {SolverError} for contradictory values
 */
async function onItsFabric(print: DesignPrint, text: string, name: string): Promise<DesignPrint> {
  if (!/"(shrinkage|measured)"/.test(text)) return print;
  const {asSewn, checkDelivered, deliveredIn} = await import('../model/print/as-sewn.js');
  const file = readPrintFile(text, name);
  checkDelivered(file);
  const delivered = file.delivered ? undefined : deliveredIn(file);
  if (!delivered) return print;
  const sewn = asSewn(file);
  const {group, size, turnDeg, cell} = print;
  return {
    ...print,
    ...{group: sewn.group, ...repeatOf(sewn), cell: sewn.cell ?? cell},
    delivered: {...delivered, stated: {group, size, turnDeg, cell}},
  };
}

/** Reads the text of a print file. @throws {Error} one sentence about the problem */
export function printFrom(text: string, name: string, words: Words): DesignPrint {
  const {
    title,
    group,
    w1,
    w2,
    cell = 'primitive',
    oneWay = false,
    image,
    unscaled,
  } = read(text, name, words);
  const repeat = repeatOf({group, w1, w2, cell});
  const again = latticeVectors(group, repeat.size, repeat.turnDeg, cell);
  const off = Math.max(distance(w1, again[0]), distance(w2, again[1]));
  // also false for NaN, as from vectors without length
  if (!(off < 0.001 * norm(w1)) || repeat.size.angleDeg <= 0) {
    throw new Error(words.wrongLattice(name, group));
  }
  return {
    title: typeof title === 'string' ? title : name.replace(/\.[^.]*$/, ''),
    ...{group, ...repeat, oneWay, cell, ...(unscaled && {unscaled})},
    image: image?.startsWith('data:image/') ? image : noPicture,
  };
}

function read(text: string, name: string, words: Words): Print {
  try {
    return readPrintFile(text, name);
  } catch (cause) {
    if (!(cause instanceof FileError)) throw cause;
    throw new Error(isPattern(text) ? words.pattern(name) : words.noPrint(name), {cause});
  }
}

/** Returns whether a file is a sewing pattern: it has pieces, or the format of one. */
function isPattern(text: string): boolean {
  try {
    const file: unknown = JSON.parse(text);
    const has = (field: string): boolean => fieldOf(file, field) !== undefined;
    const isOwn = String(fieldOf(file, 'format')).startsWith('seamwise-garment/');
    return has('pattern') || has('panels') || isOwn;
  } catch {
    return false;
  }
}

/** Printed size of an image according to its file. */
export interface FileSize {
  /** Width of the image. [cm] */
  readonly width: number;
  /** Undefined for an SVG, which has a length instead. */
  readonly dpi: number | undefined;
}

/** Resolutions that programs write by default. [dpi] */
const unasked: ReadonlySet<number> = new Set([72, 96]);

export const isUnasked = ({dpi}: FileSize): boolean =>
  dpi !== undefined && unasked.has(Math.round(dpi));

/**
 * Returns undefined if the file has no size, or one that no print can have.
 * @param image a `data:` URL
 */
export async function sizeInFile(image: string): Promise<FileSize | undefined> {
  if (!image.startsWith('data:')) return undefined;
  const size = await sizeOf(image);
  return size && size.width >= leastRepeat && size.width <= mostRepeat ? size : undefined;
}

async function sizeOf(image: string): Promise<FileSize | undefined> {
  const bytes = new Uint8Array(await blobOf(image).arrayBuffer());
  const kind = fileKind(bytes);
  if (kind === 'svg') {
    const width = lengthOnPaper(rootAttribute(new TextDecoder().decode(bytes), 'width'));
    return width === undefined ? undefined : {width, dpi: undefined};
  }
  const resolution = kind && resolutionOf(bytes, kind);
  if (!resolution) return undefined;
  const {naturalWidth} = await loadPicture(image);
  return {width: naturalWidth / resolution.across, dpi: dpiOf(resolution.across)};
}
