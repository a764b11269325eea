/** Search for a better result, on the user's request and until the user stops it. */
import {css, html, nothing, type TemplateResult} from 'lit';

import {WorkbenchElement} from '../base/workbench-element.js';
import {controls} from '../style/controls.js';
import {improvementOffer} from '../../workbench/remedies/improvement-offer.js';

export class KeepImproving extends WorkbenchElement {
  static override styles = [
    controls,
    css`
      :host {
        display: flex;
        flex-wrap: wrap;
        align-items: baseline;
        min-height: 1.5rem;
        color: var(--sw-soft);
      }
      span:not(:empty) {
        margin-inline-end: var(--sw-space-2);
      }
    `,
  ];

  protected override render(): TemplateResult | typeof nothing {
    const {afterwards} = this.workbench;
    const {design} = this.workbench.history;
    const {result, state} = this.workbench.solving;
    if (!design || !result || state.kind !== 'done' || result.seams.length === 0) return nothing;
    const {improve} = this.texts;
    const offer = improvementOffer(this.workbench);
    const words = this.#words(afterwards.improving(design));
    return html`
      <span role="status" aria-label=${improve.label} .textContent=${words}></span>
      ${
        offer &&
        html`<button class="link" title=${improve.note} @click=${offer.act}>
          ${improve[offer.kind]}
        </button>`
      }
    `;
  }

  #words(improving: ReturnType<WorkbenchElement['workbench']['afterwards']['improving']>): string {
    const {improve} = this.texts;
    if (!improving) return '';
    const {isRunning, isBetter, gained} = improving;
    if (!isBetter) return isRunning ? improve.looking : improve.nothing;
    return (isRunning ? improve.soFar : improve.gained)(gained);
  }
}
