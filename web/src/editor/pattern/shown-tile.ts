/** The tile of a workbench's print in a view: fetched once, and again when the network is back. */
import type {LitElement} from 'lit';

import type {Tile} from '../../image/tile.js';
import type {Texts} from '../../texts/texts.js';
import {toFailure} from '../../workbench/latest-solve.js';
import type {Notice, Workbench} from '../../workbench/workbench.js';
import {onceOnline} from '../../workbench/once-online.js';

interface TileView {
  setTile(tile: Tile | undefined): void;
}

export class ShownTile {
  readonly #host: LitElement & {readonly workbench: Workbench};
  readonly #calls: {readonly texts: () => Texts; readonly shown: () => void};
  /** Image of the tile that is displayed or being fetched. */
  #image: string | undefined;
  /** The image that needs the network, and its notice. */
  #awaited: {readonly image: string; readonly notice: Notice} | undefined;
  #settled: Promise<void> | undefined;

  /** @param calls `shown` runs once the tile is displayed, as far as possible */
  constructor(
    host: LitElement & {readonly workbench: Workbench},
    calls: {readonly texts: () => Texts; readonly shown: () => void},
  ) {
    this.#host = host;
    this.#calls = calls;
  }

  /** Resolves once the last requested tile, or its substitute, is displayed. */
  get settled(): Promise<void> | undefined {
    return this.#settled;
  }

  /** Forgets the tile, since the view is gone. */
  forget(): void {
    this.#image = undefined;
  }

  /**
   * Shows the tile of the workbench's print, unless it is displayed already.
   * @param signal cancels the fetch
   */
  show(view: TileView, signal: AbortSignal): void {
    const image = this.#host.workbench.history.design?.print.image;
    if (image === undefined || image === this.#image) return;
    this.#image = image;
    this.#settled = this.#fetch(view, image, signal);
  }

  async #fetch(view: TileView, image: string, signal: AbortSignal): Promise<void> {
    const {workbench} = this.#host;
    try {
      const tile = await workbench.tileOf(image, signal);
      if (this.#image !== image) return;
      view.setTile(tile);
      if (this.#awaited && workbench.notices.notice === this.#awaited.notice)
        workbench.notices.say(undefined);
      this.#awaited = undefined;
    } catch (error) {
      if (this.#image !== image || signal.aborted) return;
      view.setTile(undefined);
      this.#miss(image, error, signal);
    }
    if (this.#image === image) this.#calls.shown();
  }

  /**
   * Shows a notice. Without network, the fetch repeats later unless the tile is no longer needed.
   */
  #miss(image: string, error: unknown, signal: AbortSignal): void {
    const {workbench} = this.#host;
    const isUnreached = error instanceof TypeError && !image.startsWith('data:');
    if (!isUnreached) {
      workbench.notices.say({tone: 'error', text: toFailure(error).message});
      return;
    }
    if (this.#awaited?.image !== image) {
      const title = workbench.history.design?.print.title ?? image;
      const notice: Notice = {tone: 'info', text: this.#calls.texts().offline.waits(title)};
      this.#awaited = {image, notice};
      workbench.notices.say(notice);
    }
    onceOnline(() => {
      if (this.#image !== image) return;
      this.#image = undefined;
      this.#host.requestUpdate();
    }, signal);
  }
}
