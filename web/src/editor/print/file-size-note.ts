/** Printed size of an image according to its file, beside the size that the user entered. */
import {css, html, nothing, type TemplateResult} from 'lit';

import type {DesignPrint} from '../../model/design/design.js';
import {pictureIn, resized, tileSize} from '../../model/design/tile-repeat.js';
import {WorkbenchElement} from '../base/workbench-element.js';
import {controls} from '../style/controls.js';
import {firstWidth, isUnasked, sizeInFile, type FileSize} from '../../print/read-print.js';

/** Greatest difference between equal sizes. [cm] */
const same = 0.005;

export class FileSizeNote extends WorkbenchElement {
  static override properties = {...WorkbenchElement.properties, said: {state: true}};
  declare protected said: {readonly image: string; readonly size: FileSize | undefined} | undefined;
  #looked = '';

  static override styles = [
    controls,
    css`
      button {
        white-space: normal;
        text-align: start;
      }
    `,
  ];

  protected override updated(): void {
    const print = this.workbench.history.design?.print;
    if (!print) return;
    const {image} = pictureIn(print);
    if (image === this.#looked) return;
    this.#looked = image;
    void sizeInFile(image)
      .catch(() => undefined)
      .then((size) => {
        if (this.#looked === image) this.said = {image, size};
      });
  }

  protected override render(): TemplateResult | typeof nothing {
    const print = this.workbench.history.design?.print;
    const {said} = this;
    if (!print || said?.image !== pictureIn(print).image) return nothing;
    const texts = this.texts.print;
    if (print.unscaled) return html`<p class="soft">${texts.unscaled}</p>`;
    const {width} = tileSize(print);
    if (!said.size) {
      const isGuess = Math.abs(width - firstWidth) < same;
      return isGuess ? html`<p class="soft">${texts.sizeUnknown}</p>` : nothing;
    }
    const {dpi} = said.size;
    const resolution = dpi === undefined ? texts.onPaper : texts.dpi(this.format.number(dpi, 0));
    const length = this.format.length(said.size.width);
    const isTaken = Math.abs(width - said.size.width) < same;
    return html`${
      isTaken
        ? html`<p class="soft">${texts.fromFile(resolution, length)}</p>`
        : html`<button
            class="link"
            @click=${() => {
              this.#take(print, said.size?.width ?? width);
            }}
          >
            ${texts.backToFile(resolution, length)}
          </button>`
    }
    ${isTaken && isUnasked(said.size) ? html`<p class="soft">${texts.unasked}</p>` : nothing}`;
  }

  /** Keeps the proportions. */
  #take(print: DesignPrint, width: number): void {
    const size = tileSize(print);
    const height = (size.height * width) / size.width;
    this.workbench.history.change({print: resized(print, {...size, width, height})}, 'print size');
  }
}
