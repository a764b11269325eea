/**
 * Controls under a pattern in `mode="place"`: print scale, and the choice of a print if there are
 * several.
 */
import {css, html, nothing, type TemplateResult} from 'lit';

import type {DesignPrint} from '../../model/design/design.js';
import {coupledSize} from '../../model/print/repeat.js';
import {lengthUnit} from '../../editor/controls/number-field.js';
import {WorkbenchElement} from '../../editor/base/workbench-element.js';
import {swatch} from '../../editor/print/swatch.js';
import {controls} from '../../editor/style/controls.js';
import {holdWhilePressed} from '../../editor/base/hold.js';
import type {OfferedPrint} from './sources.js';
import {defineParts} from '../../editor/parts.js';
import {ToolHint} from '../../editor/pattern/tool-hint.js';
import {registerAll} from '../../editor/base/register.js';

/** The slider's ends, as multiples of the repeat in the print's file. */
const [least, most] = [0.25, 4];
const steps = 100;

/** Fires `sw-print` with the chosen print as `detail`. */
class PlaceBar extends WorkbenchElement {
  static override properties = {
    ...WorkbenchElement.properties,
    prints: {attribute: false},
    chosen: {},
  };
  declare prints: readonly OfferedPrint[];
  /** URL of the shown print. */
  declare chosen: string;
  /** Repeat at the slider's middle, while the print is the same. [cm] */
  #usual: {readonly image: string; readonly width: number} | undefined;

  static override styles = [
    controls,
    css`
      :host {
        display: grid;
        gap: var(--sw-space-2);
        padding: var(--sw-space-2) var(--sw-space-3) var(--sw-space-3);
        border-top: 1px solid var(--sw-line);
        background: var(--sw-paper);
      }
      .scale {
        display: grid;
        grid-template-columns: minmax(0, 1fr) 7.5rem;
        align-items: end;
        gap: var(--sw-space-4);
      }
      input[type='range'] {
        width: 100%;
        height: 2rem;
        margin: 0;
        accent-color: var(--sw-accent);
      }
      .prints {
        display: flex;
        gap: var(--sw-space-2);
        padding: 2px;
        overflow-x: auto;
        scrollbar-width: thin;
      }
      .prints button {
        display: grid;
        flex: none;
        width: 4.5rem;
        min-height: 0;
        padding: var(--sw-space-1);
        font-size: var(--sw-text);
        white-space: normal;
      }
      svg,
      .blank {
        display: block;
        width: 100%;
        aspect-ratio: 1;
        border-radius: calc(var(--sw-radius) - 2px);
        background: var(--sw-tint);
      }
      .prints span {
        overflow: hidden;
        text-overflow: ellipsis;
        white-space: nowrap;
        max-width: 100%;
      }
    `,
  ];

  protected override render(): TemplateResult | typeof nothing {
    const print = this.workbench.history.design?.print;
    if (!print) return nothing;
    return html`${this.#gallery()} ${this.#scale(print)}`;
  }

  #scale(print: DesignPrint): TemplateResult {
    const {garment, controls: words} = this.texts;
    if (this.#usual?.image !== print.image) {
      this.#usual = {image: print.image, width: print.size.width};
    }
    const {name, cm} = lengthUnit[this.workbench.preferences.chosen.units];
    const label = garment.scale(name);
    const usual = this.#usual.width;
    const [from, to] = [least * usual, most * usual];
    const {width} = print.size;
    return html`<div class="scale">
      <input
        type="range"
        aria-label=${label}
        aria-valuetext=${this.format.length(width)}
        min="0"
        max=${steps}
        .value=${String(Math.round(steps * share(width, from, to)))}
        @pointerdown=${(event: PointerEvent) => {
          holdWhilePressed(this.workbench, event);
        }}
        @input=${(event: Event) => {
          const {valueAsNumber} = event.target as HTMLInputElement;
          this.#resize(print, from * (to / from) ** (valueAsNumber / steps));
        }}
      />
      <sw-number-field
        .label=${label}
        .value=${width / cm}
        .subject=${print.image}
        .least=${from / cm}
        .most=${to / cm}
        .step=${0.1}
        .fractions=${this.workbench.preferences.chosen.units === 'inch'}
        .wrong=${words.between(this.format.length(from), this.format.length(to))}
        @entered=${({detail}: CustomEvent<number>) => {
          this.#resize(print, detail * cm);
        }}
      ></sw-number-field>
    </div>`;
  }

  #gallery(): TemplateResult | typeof nothing {
    if (this.prints.length === 0) return nothing;
    return html`<div class="prints" role="group" aria-label=${this.texts.garment.prints}>
      ${this.prints.map(
        (offered, k) =>
          html`<button
            aria-pressed=${offered.url === this.chosen}
            title=${offered.title}
            @click=${() => {
              this.dispatchEvent(new CustomEvent<OfferedPrint>('sw-print', {detail: offered}));
            }}
          >
            ${
              offered.print
                ? swatch(`print-${k}`, offered.print, offered.print.image)
                : html`<i class="blank"></i>`
            }
            <span>${offered.title}</span>
          </button>`,
      )}
    </div>`;
  }

  /** Scales both sides of the cell by the same factor, rounded to a measurable length. */
  #resize(print: DesignPrint, wanted: number): void {
    const width = Math.round(wanted * 100) / 100;
    const {size, group} = print;
    const height = (size.height * width) / size.width;
    this.workbench.history.change(
      {print: {...print, size: coupledSize(group, {...size, width, height})}},
      'print size',
    );
  }
}

/** Returns a logarithmic share from 0 to 1: the middle is the geometric mean of both ends. */
const share = (value: number, from: number, to: number): number =>
  Math.min(1, Math.max(0, Math.log(value / from) / Math.log(to / from)));

/** Parts for placing the print; loaded only then. */
export function definePlacing(): void {
  defineParts();
  registerAll({'sw-place-bar': PlaceBar, 'sw-tool-hint': ToolHint});
}
