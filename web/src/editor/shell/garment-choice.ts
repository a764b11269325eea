/** Choice of the garment and of its size. */
import {css, html, nothing, type TemplateResult} from 'lit';

import {WorkbenchElement} from '../base/workbench-element.js';
import {controls} from '../style/controls.js';
import {toFailure} from '../../workbench/latest-solve.js';
import {onceOnline} from '../../workbench/once-online.js';
import {sampleGarment, Unreachable, type Samples} from '../../workbench/samples.js';

export class GarmentChoice extends WorkbenchElement {
  static override properties = {...WorkbenchElement.properties, samples: {attribute: false}};
  declare samples: Samples | undefined;
  /** Cancels the loading of the garment that was chosen last. */
  #waits: AbortController | undefined;

  static override styles = [
    controls,
    css`
      :host {
        display: grid;
        grid-template-columns: minmax(0, 1fr) auto;
        gap: var(--sw-space-2);
        min-height: var(--sw-target);
      }
      select {
        text-overflow: ellipsis;
        cursor: pointer;
      }
      select + select {
        width: auto;
      }
      option {
        background: var(--sw-raised);
        color: var(--sw-ink);
      }
    `,
  ];

  /** Focuses the list of garments. */
  override focus(): void {
    this.renderRoot.querySelector('select')?.focus();
  }

  /** Focuses the list of garments, and opens it where the browser allows that. */
  open(): void {
    this.focus();
    try {
      this.renderRoot.querySelector('select')?.showPicker();
    } catch {
      // the list has the focus, and opens with a key or a click
    }
  }

  override disconnectedCallback(): void {
    super.disconnectedCallback();
    this.#waits?.abort();
  }

  /** Resets the lists to the present garment, since a browser keeps the user's choice in a list. */
  protected override updated(): void {
    const {style = '', size = ''} = this.workbench.history.design?.garment.sample ?? {};
    this.renderRoot.querySelectorAll('select').forEach((list, k) => {
      list.value = k === 0 ? style : size;
    });
  }

  protected override render(): TemplateResult | typeof nothing {
    const {design} = this.workbench.history;
    if (!design || !this.samples) return nothing;
    const {app} = this.texts;
    const {sample, name} = design.garment;
    const style = this.samples.garments.find((one) => one.style === sample?.style);
    return html`
      <select
        aria-label=${app.garment}
        @change=${(event: Event) => {
          void this.choose((event.target as HTMLSelectElement).value, sample?.size ?? 'm');
        }}
      >
        ${style ? nothing : html`<option value="">${name}</option>`}
        ${this.samples.garments.map(
          (one) =>
            html`<option value=${one.style}>
              ${this.texts.samples.garments[one.style] ?? one.title}
            </option>`,
        )}
      </select>
      ${
        style &&
        html`<select
          aria-label=${app.size}
          @change=${(event: Event) => {
            void this.choose(style.style, (event.target as HTMLSelectElement).value);
          }}
        >
          ${style.sizes.map((size) => html`<option value=${size}>${size.toUpperCase()}</option>`)}
        </select>`
      }
    `;
  }

  /** Another size keeps all decisions about the garment; another garment cannot keep them. */
  async choose(style: string, size: string, isAgain = false): Promise<void> {
    this.#waits?.abort();
    if (style === '') return;
    this.#waits = new AbortController();
    const {signal} = this.#waits;
    try {
      const garment = await sampleGarment(style, size, signal);
      if (style === this.workbench.history.design?.garment.sample?.style)
        this.workbench.history.change({garment});
      else await this.workbench.open(garment);
    } catch (error) {
      if (signal.aborted) return;
      if (error instanceof Unreachable) this.#await(style, size, isAgain, signal);
      else this.workbench.notices.say({tone: 'error', text: toFailure(error).message});
      this.requestUpdate(); // resets the lists to the displayed garment
    }
  }

  /** Repeats the choice once the network is back, unless another choice comes first. */
  #await(style: string, size: string, isAgain: boolean, signal: AbortSignal): void {
    const sample = this.samples?.garments.find((one) => one.style === style);
    const title = this.texts.samples.garments[style] ?? sample?.title ?? style;
    if (!isAgain) this.workbench.notices.say({tone: 'info', text: this.texts.offline.waits(title)});
    onceOnline(() => void this.choose(style, size, true), signal);
  }
}
