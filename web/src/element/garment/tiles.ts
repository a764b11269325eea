/**
 * Images of an element's prints. Each image is fetched once while the element is in use, and
 * reported once if it is unreadable.
 */
import {SolverError} from '../../model/base/failure.js';
import {noPicture} from '../../model/design/design.js';
import {svgTile, type Tile} from '../../image/tile.js';
import {hasOutsidePictures} from '../../image/svg-picture.js';
import type {Texts} from '../../texts/texts.js';
import {blobOf} from '../../image/data-url.js';
import {fetchBlob} from './sources.js';
import {asError} from './emitted-events.js';

/** Limits of an image; each decoded pixel takes 4 bytes. */
const mostPixels = 64e6;
const longestSide = 20_000;
/**
 * Longest side of a texture; larger images are reduced while decoding, off the main thread. [px]
 */
const finest = 4096;

export class Tiles {
  readonly #texts: () => Texts;
  readonly #report: (error: SolverError) => void;
  /** The last image; a bitmap is kept as a file, since pixels take far more memory. */
  #last: {readonly image: string; readonly open: Promise<() => Promise<Tile>>} | undefined;
  /** The last reported image. */
  #unreadable: string | undefined;

  /** @param report receives the error of an unreadable image, once */
  constructor(texts: () => Texts, report: (error: SolverError) => void) {
    this.#texts = texts;
    this.#report = report;
  }

  /**
   * @throws {SolverError} as `fetchBlob`, `too-large`, `not-an-image`; the signal's reason when it
   * fires
   */
  async tile(image: string, signal?: AbortSignal): Promise<Tile | undefined> {
    if (image !== this.#unreadable) this.#unreadable = undefined;
    try {
      return await this.#tile(image, signal);
    } catch (error) {
      if (!signal?.aborted && image !== this.#unreadable) {
        this.#unreadable = image;
        this.#report(asError(error));
      }
      throw error;
    }
  }

  async #tile(image: string, signal: AbortSignal | undefined): Promise<Tile | undefined> {
    // fetches nothing that a content security policy could forbid
    if (image === noPicture) return undefined;
    if (this.#last?.image !== image) {
      const open = this.#open(image);
      this.#last = {image, open};
      open.catch(() => {
        if (this.#last?.open === open) this.#last = undefined; // allows another attempt
      });
    }
    const tile = await (await this.#last.open)();
    signal?.throwIfAborted();
    return tile;
  }

  async #open(image: string): Promise<() => Promise<Tile>> {
    const {garment: words, print} = this.#texts();
    const called = image.startsWith('data:') ? image.slice(0, 40) : image;
    const notAnImage = new SolverError({code: 'not-an-image', message: words.notAnImage(called)});
    const decoded = async <T>(read: () => Promise<T>): Promise<T> => {
      try {
        return await read();
      } catch {
        throw notAnImage;
      }
    };
    const isHere = image.startsWith('data:');
    const blob = isHere
      ? await decoded(() => Promise.resolve(blobOf(image)))
      : await fetchBlob(image, words);
    if (blob.type.startsWith('image/svg')) {
      const text = await blob.text();
      if (hasOutsidePictures(text)) {
        const message = print.files.outsidePictures(called);
        throw new SolverError({code: 'not-an-image', message});
      }
      // an SVG is drawn at the size for the screen, regardless of its own size
      const tile = await decoded(async () =>
        readable(isHere ? await svgTile(text) : await vector(image)),
      );
      return () => Promise.resolve(tile);
    }
    const size = pictureSize(new Uint8Array(await blob.arrayBuffer()));
    if (!size) throw notAnImage;
    if (!isSmallEnough(size)) {
      const message = words.tooLarge(called, `${mostPixels / 1e6} MP`);
      throw new SolverError({code: 'too-large', message});
    }
    const options: ImageBitmapOptions = {colorSpaceConversion: 'none', ...reduced(size)};
    return () => decoded(() => createImageBitmap(blob, options));
  }
}

/** Loads an SVG from its own URL: a content security policy need not allow others. */
async function vector(url: string): Promise<Tile> {
  const image = new Image();
  image.crossOrigin = 'anonymous'; // an image from another origin taints the canvas without CORS
  image.src = url;
  await image.decode();
  return {vector: image};
}

/** @throws {Error} for an SVG that taints the canvas, as SVG with HTML does in some browsers */
function readable(tile: Tile): Tile {
  const context = document.createElement('canvas').getContext('2d');
  if ('vector' in tile) context?.drawImage(tile.vector, 0, 0, 1, 1);
  context?.getImageData(0, 0, 1, 1);
  return tile;
}

/** Returns undefined for an image that needs no reduction. */
function reduced({width, height}: PictureSize): ImageBitmapOptions | undefined {
  const shrink = finest / Math.max(width, height);
  if (shrink >= 1) return undefined;
  const side = (length: number): number => Math.max(1, Math.round(length * shrink));
  // four neighbours suffice down to half the size, and are fastest
  const resizeQuality = shrink < 0.5 ? 'medium' : 'low';
  return {resizeWidth: side(width), resizeHeight: side(height), resizeQuality};
}

const isSmallEnough = ({width, height}: PictureSize): boolean =>
  Math.max(width, height) <= longestSide && width * height <= mostPixels;

/**
 * Reads the size of an image from the first bytes of its file, before a browser decodes the pixels.
 */
interface PictureSize {
  readonly width: number;
  readonly height: number;
}

/** Returns undefined for files other than PNG, JPEG, WebP, GIF and AVIF. */
function pictureSize(bytes: Uint8Array): PictureSize | undefined {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  try {
    if (view.getUint32(0) === 0x89504e47) {
      return {width: view.getUint32(16), height: view.getUint32(20)};
    }
    if (view.getUint32(0) === 0x47494638) return gif(view);
    if (view.getUint32(0) === 0x52494646 && view.getUint32(8) === 0x57454250) return webp(view);
    if (view.getUint32(4) === 0x66747970) return avif(view);
    return view.getUint16(0) === 0xffd8 ? jpeg(view) : undefined;
  } catch (error) {
    if (error instanceof RangeError) return undefined; // the file ends too early
    throw error;
  }
}

/** Skips segments up to that of the first frame, which contains the size. */
function jpeg(view: DataView): PictureSize | undefined {
  for (let at = 2; ;) {
    const marker = view.getUint16(at);
    if (marker === 0xffff)
      at++; // padding
    else if (marker === 0xff01 || (marker >= 0xffd0 && marker <= 0xffd7))
      at += 2; // marker without data
    else if (marker >= 0xffc0 && marker <= 0xffcf && ![0xffc4, 0xffc8, 0xffcc].includes(marker)) {
      return {width: view.getUint16(at + 7), height: view.getUint16(at + 5)};
    } else if (marker > 0xff01) at += 2 + view.getUint16(at + 2);
    else return undefined;
  }
}

/** Includes the first frame, which may be larger than the whole image. */
function gif(view: DataView): PictureSize | undefined {
  const colours = (flags: number): number => (flags & 0x80 ? 3 * 2 ** ((flags & 7) + 1) : 0);
  let at = 13 + colours(view.getUint8(10));
  while (view.getUint8(at) === 0x21) {
    at += 2; // an extension: blocks, the last of which is empty
    while (view.getUint8(at) > 0) at += 1 + view.getUint8(at);
    at++;
  }
  if (view.getUint8(at) !== 0x2c) return undefined;
  const side = (whole: number, offset: number): number =>
    Math.max(
      view.getUint16(whole, true),
      view.getUint16(at + offset, true) + view.getUint16(at + offset + 4, true),
    );
  return {width: side(6, 1), height: side(8, 3)};
}

function webp(view: DataView): PictureSize | undefined {
  switch (view.getUint32(12)) {
    case 0x56503820: // lossy
      return {width: view.getUint16(26, true) & 0x3fff, height: view.getUint16(28, true) & 0x3fff};
    case 0x5650384c: {
      // lossless: 14 bits each
      const bits = view.getUint32(21, true);
      return {width: (bits & 0x3fff) + 1, height: ((bits >> 14) & 0x3fff) + 1};
    }
    case 0x56503858: {
      const side = (at: number): number => (view.getUint32(at, true) & 0xffffff) + 1;
      return {width: side(24), height: side(27)};
    }
    default:
      return undefined;
  }
}

/**
 * Reads the sizes of an image's parts (`ispe`) in the boxes before the data; the largest is that of
 * the whole.
 */
function avif(view: DataView): PictureSize | undefined {
  let [width, height] = [0, 0];
  for (let at = 0; at + 8 <= view.byteLength;) {
    const length = view.getUint32(at);
    const type = view.getUint32(at + 4);
    const end = Math.min(at + length, view.byteLength);
    if (type === 0x6d657461) {
      for (let k = at + 8; k + 16 <= end; k++) {
        if (view.getUint32(k) !== 0x69737065) continue;
        width = Math.max(width, view.getUint32(k + 8));
        height = Math.max(height, view.getUint32(k + 12));
      }
    }
    // 0: to the end of the file; 1: 64-bit length, longer than any accepted image
    if (length < 8) break;
    at += length;
  }
  return width > 0 && height > 0 ? {width, height} : undefined;
}
