/** Choice of the repeat of the user's own image, with a small drawing of each. */
import {css, html, nothing, svg, type SVGTemplateResult, type TemplateResult} from 'lit';

import {pictureIn} from '../../model/design/tile-repeat.js';
import {tileRepeats, type TileRepeat} from '../../model/print/opened-image.js';
import {WorkbenchElement} from '../base/workbench-element.js';
import {controls} from '../style/controls.js';
import {printOfPicture} from '../../print/own-print.js';

/** A leaf without symmetry, in a square of side 10. */
const leaf = 'M2.2 8.2C1.6 4.4 4 1.8 8.2 1.6C8.4 4.6 6.6 7.2 3.4 7.2z';

function drawing(repeat: TileRepeat): SVGTemplateResult {
  const tiles: SVGTemplateResult[] = [];
  for (let i = -1; i < 4; i++) {
    for (let j = -1; j < 4; j++) {
      const x = 10 * i + (repeat === 'brick' && j % 2 !== 0 ? 5 : 0);
      const y = 10 * j + (repeat === 'halfDrop' && i % 2 !== 0 ? 5 : 0);
      const flipX = repeat.startsWith('mirrored') && repeat !== 'mirroredUp' && i % 2 !== 0;
      const flipY = (repeat === 'mirrored' || repeat === 'mirroredUp') && j % 2 !== 0;
      const place = `translate(${x + (flipX ? 10 : 0)} ${y + (flipY ? 10 : 0)})`;
      const flip = `scale(${flipX ? -1 : 1} ${flipY ? -1 : 1})`;
      tiles.push(
        svg`<g transform="${place} ${flip}"><rect width="10" height="10"></rect><path d=${leaf}></path></g>`,
      );
    }
  }
  return svg`${tiles}`;
}

export class TileRepeatChoice extends WorkbenchElement {
  static override styles = [
    controls,
    css`
      :host {
        display: grid;
        gap: var(--sw-space-2);
      }
      .ways {
        display: grid;
        grid-template-columns: repeat(3, minmax(0, 1fr));
        gap: var(--sw-space-2);
      }
      button {
        display: grid;
        align-content: start;
        gap: var(--sw-space-1);
        height: auto;
        padding: var(--sw-space-1);
        border-color: var(--sw-line);
        background: var(--sw-raised);
        font-size: var(--sw-text);
        line-height: 1.25;
        white-space: normal;
      }
      button[aria-checked='true'] {
        border-color: var(--sw-accent);
        background: var(--sw-tint);
        color: var(--sw-accent);
        font-weight: 600;
      }
      svg {
        width: 100%;
        aspect-ratio: 3 / 2;
        border-radius: 3px;
      }
      rect {
        fill: none;
        stroke: var(--sw-line);
        stroke-width: 0.6;
      }
      path {
        fill: currentColor;
      }
    `,
  ];

  protected override render(): TemplateResult | typeof nothing {
    const print = this.workbench.history.design?.print;
    if (!print) return nothing;
    const texts = this.texts.print.repeats;
    const chosen = pictureIn(print).repeat;
    return html`<h3 id="title">${texts.label}</h3>
      <div
        class="ways"
        role="radiogroup"
        aria-labelledby="title"
        @keydown=${(event: KeyboardEvent) => {
          this.#walk(event, chosen);
        }}
      >
        ${tileRepeats.map(
          (repeat) =>
            html`<button
              id=${repeat}
              role="radio"
              aria-checked=${repeat === chosen}
              tabindex=${repeat === chosen ? 0 : -1}
              @click=${() => this.#take(repeat)}
            >
              <svg viewBox="0 0 30 20" aria-hidden="true">${drawing(repeat)}</svg>
              ${texts[repeat]}
            </button>`,
        )}
      </div>`;
  }

  #walk(event: KeyboardEvent, chosen: TileRepeat): void {
    const step = {ArrowLeft: -1, ArrowUp: -1, ArrowRight: 1, ArrowDown: 1}[event.key];
    if (step === undefined) return;
    event.preventDefault();
    const count = tileRepeats.length;
    const next = tileRepeats[(tileRepeats.indexOf(chosen) + step + count) % count];
    if (next === undefined) return;
    this.renderRoot.querySelector<HTMLElement>(`#${next}`)?.focus();
    void this.#take(next);
  }

  async #take(repeat: TileRepeat): Promise<void> {
    const print = this.workbench.history.design?.print;
    if (!print || pictureIn(print).repeat === repeat) return;
    const taken = await printOfPicture(this.workbench.solver, {...pictureIn(print), repeat});
    if (this.workbench.history.design?.print === print)
      this.workbench.history.change({print: taken}, 'print repeat');
  }
}
