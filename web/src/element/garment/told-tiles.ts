/** Images of prints for several parts of an editor; reports each unreadable image once. */
import type {Tile} from '../../image/tile.js';
import type {SolverError} from '../../model/result/failure.js';
import type {Texts} from '../../texts/texts.js';
import {asError} from './as-error.js';
import {Tiles} from './tiles.js';

export class ToldTiles {
  readonly #tiles: Tiles;
  readonly #tell: (error: SolverError) => void;
  /** The last reported image. */
  #unreadable: string | undefined;

  constructor(texts: () => Texts, tell: (error: SolverError) => void) {
    this.#tiles = new Tiles(texts);
    this.#tell = tell;
  }

  /** @throws {Error} if the image cannot be read */
  async tile(image: string, signal?: AbortSignal): Promise<Tile | undefined> {
    if (image !== this.#unreadable) this.#unreadable = undefined;
    try {
      return await this.#tiles.tile(image, signal);
    } catch (error) {
      if (!signal?.aborted && image !== this.#unreadable) {
        this.#unreadable = image;
        this.#tell(asError(error));
      }
      throw error;
    }
  }
}
