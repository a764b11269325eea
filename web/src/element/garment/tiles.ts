/** The pictures of an element's prints. A picture is fetched once, for as long as the element is in use. */
import {SolverError} from '../../model/failure.js';
import {noPicture} from '../../model/design.js';
import type {Tile} from '../../viewer/tile.js';
import {tileOf} from '../pattern/tile.js';
import {fetchBlob, type FileWords} from './files.js';
import {pictureSize} from './picture-size.js';

/** What is decoded takes 4 bytes for each pixel. */
const mostPixels = 64e6;
const longestSide = 20_000;

export class Tiles {
  readonly #words: () => FileWords;
  /** The last picture: as a file where it is made of pixels, which take far more room. */
  #last: {readonly image: string; readonly open: Promise<() => Promise<Tile>>} | undefined;

  constructor(words: () => FileWords) {
    this.#words = words;
  }

  /** @throws {SolverError} as `fetchBlob` does, `too-large`, `not-an-image`; the signal's reason when it fires */
  async tile(image: string, signal?: AbortSignal): Promise<Tile | undefined> {
    if (image === noPicture) return undefined; // nothing that a policy could forbid
    if (this.#last?.image !== image) {
      const open = this.#open(image);
      this.#last = {image, open};
      open.catch(() => {
        if (this.#last?.open === open) this.#last = undefined; // to be tried again
      });
    }
    const tile = await (await this.#last.open)();
    signal?.throwIfAborted();
    return tile;
  }

  async #open(image: string): Promise<() => Promise<Tile>> {
    const words = this.#words();
    const called = image.startsWith('data:') ? image.slice(0, 40) : image;
    const decoded = async (read: () => Promise<Tile>): Promise<Tile> => {
      try {
        return await read();
      } catch {
        throw new SolverError({code: 'not-an-image', message: words.notAnImage(called)});
      }
    };
    if (image.startsWith('data:')) return () => decoded(() => tileOf(image));
    const blob = await fetchBlob(image, words);
    if (blob.type.startsWith('image/svg')) {
      const tile = await decoded(async () => {
        const vector = new Image();
        vector.src = image; // the URL itself: a policy need not allow others
        await vector.decode();
        return {vector};
      });
      return () => Promise.resolve(tile);
    }
    const size = pictureSize(new Uint8Array(await blob.arrayBuffer()));
    if (size && !isSmallEnough(size)) {
      const message = words.tooLarge(called, `${mostPixels / 1e6} MP`);
      throw new SolverError({code: 'too-large', message});
    }
    return () => decoded(() => createImageBitmap(blob, {colorSpaceConversion: 'none'}));
  }
}

const isSmallEnough = ({width, height}: {width: number; height: number}): boolean =>
  Math.max(width, height) <= longestSide && width * height <= mostPixels;
