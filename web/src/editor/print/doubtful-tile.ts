/** An opened image that is not seamless: its open edges, and remedies. */
import {css, html, nothing, type PropertyValues, type TemplateResult} from 'lit';

import type {TileRepeat} from '../../model/print/opened-image.js';
import {blobOf} from '../../image/data-url.js';
import {takePrint} from '../../workbench/print/take-print.js';
import {WorkbenchElement} from '../base/workbench-element.js';
import {controls} from '../style/controls.js';
import type {DoubtfulPicture} from '../../workbench/state.js';
import {edgesPath, markedTile, markedTileStyle} from './marked-tile.js';
import {closedRepeats, openPairs} from '../../print/own-groups.js';
import {printOfPicture} from '../../print/own-print.js';
import type {PhotoOfFabric} from '../../print/openable-files.js';
import {remedies} from './tile-report.js';

/**
 * Fires `another` if the user wants another file, and `photo` with a `PhotoOfFabric` if the image is
 * a photo.
 */
export class DoubtfulTile extends WorkbenchElement {
  static override properties = {...WorkbenchElement.properties, repeats: {state: true}};
  /** Repeats that make the image seamless. */
  declare protected repeats: readonly TileRepeat[];
  #shown: DoubtfulPicture | undefined;

  static override styles = [
    controls,
    markedTileStyle,
    css`
      :host {
        display: block;
      }
    `,
  ];

  constructor() {
    super();
    this.repeats = [];
  }

  protected override willUpdate(changed: PropertyValues<this>): void {
    super.willUpdate(changed);
    const {doubtful} = this.workbench.notices;
    if (doubtful === this.#shown) return;
    this.#shown = doubtful;
    this.repeats = [];
    if (!doubtful) return;
    void closedRepeats(this.workbench.solver, doubtful.own.image).then((repeats) => {
      if (this.#shown === doubtful) this.repeats = repeats;
    });
  }

  protected override render(): TemplateResult | typeof nothing {
    const {doubtful} = this.workbench.notices;
    if (!doubtful) return nothing;
    const texts = this.texts.print;
    const {own, edges} = doubtful;
    return html`<div class="breaks" role="group" aria-label=${texts.remedy.label}>
      ${markedTile({
        ...{image: own.image, size: own.size, turnDeg: 0, marks: edgesPath(edges)},
        label: texts.marked(own.title),
      })}
      <div>
        <p role="status">${texts.doubtful(own.title)} ${texts.openEdges[openPairs(edges)]}</p>
        <div class="row">
          ${remedies(texts, this.repeats, (repeat) => this.#take(doubtful, repeat))}
          <button
            class="outlined"
            @click=${() => {
              this.dispatchEvent(new CustomEvent('another'));
            }}
          >
            ${texts.remedy.another}
          </button>
          <button
            class="outlined"
            @click=${() => {
              const detail = {picture: blobOf(own.image), name: own.title};
              this.dispatchEvent(new CustomEvent<PhotoOfFabric>('photo', {detail}));
            }}
          >
            ${texts.remedy.photo}
          </button>
          <button @click=${() => this.#take(doubtful, 'straight')}>${texts.remedy.anyway}</button>
        </div>
      </div>
    </div>`;
  }

  async #take(doubtful: DoubtfulPicture, repeat: TileRepeat): Promise<void> {
    const print = await printOfPicture(this.workbench.solver, {...doubtful.own, repeat});
    if (this.workbench.notices.doubtful !== doubtful) return;
    this.workbench.notices.doubtful = undefined;
    takePrint(this.workbench, print);
  }
}
