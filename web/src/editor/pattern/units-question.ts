/** Question about the unit of a file, if the garment would fit no person. */
import {css, html, nothing, type TemplateResult} from 'lit';

import type {DesignGarment} from '../../model/design/design.js';
import {WorkbenchElement} from '../base/workbench-element.js';
import {controls} from '../style/controls.js';
import {inUnit} from '../../model/garment/write-garment.js';

export class UnitsQuestion extends WorkbenchElement {
  static override styles = [
    controls,
    css`
      div {
        display: flex;
        flex-wrap: wrap;
        align-items: center;
        gap: var(--sw-space-2);
        padding: var(--sw-space-2) var(--sw-space-4);
        border-bottom: 1px solid var(--sw-line);
        background: var(--sw-tint);
      }
    `,
  ];

  /** The garment whose unit the user has confirmed. */
  #confirmed: DesignGarment | undefined;

  protected override render(): TemplateResult | typeof nothing {
    const {design} = this.workbench.history;
    const {garment: document} = this.workbench.solving;
    const [question] = document?.questions ?? [];
    if (!design || !question || design.garment === this.#confirmed) return nothing;
    const {doubt} = this.texts;
    const {garment} = design;
    return html`<div role="status">
      <span>${doubt.question(this.format.length(question.tallestCm))}</span>
      <button
        class="outlined"
        @click=${() => {
          this.#confirmed = garment;
          this.requestUpdate();
        }}
      >
        ${doubt.yes}
      </button>
      ${question.likely.map(
        (unit) =>
          html`<button
            class="outlined"
            @click=${() => {
              this.workbench.history.change({
                garment: {...garment, text: inUnit(garment.text, unit)},
              });
            }}
          >
            ${doubt.no(doubt.units[unit])}
          </button>`,
      )}
    </div>`;
  }
}
