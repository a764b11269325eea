/** Images of an element's prints. Each image is fetched once while the element is in use. */
import {SolverError} from '../../model/result/failure.js';
import {noPicture} from '../../model/design/design.js';
import {svgTile, type Tile} from '../../image/tile.js';
import {hasOutsidePictures} from '../../image/svg-picture.js';
import type {Texts} from '../../texts/texts.js';
import {blobOf} from '../../image/data-url.js';
import {fetchBlob} from './files.js';
import {pictureSize, type PictureSize} from './picture-size.js';

/** Limits of an image; each decoded pixel takes 4 bytes. */
const mostPixels = 64e6;
const longestSide = 20_000;
/**
 * Longest side of a texture; larger images are reduced while decoding, off the main thread. [px]
 */
const finest = 4096;

export class Tiles {
  readonly #texts: () => Texts;
  /** The last image; a bitmap is kept as a file, since pixels take far more memory. */
  #last: {readonly image: string; readonly open: Promise<() => Promise<Tile>>} | undefined;

  constructor(texts: () => Texts) {
    this.#texts = texts;
  }

  /**
   * @throws {SolverError} as `fetchBlob`, `too-large`, `not-an-image`; the signal's reason when it
   * fires
   */
  async tile(image: string, signal?: AbortSignal): Promise<Tile | undefined> {
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
